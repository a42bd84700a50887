#include "devices/hid/hid_protocol.h"

#include <chrono>
#include <utility>

#include "devices/hid/haptic_page.h"

namespace tact {

namespace {

// Whether a report comes that is what is waited for; others pass by meanwhile.
bool comes(const HidPort& port, int wait_ms, const std::function<bool(const Packet&)>& wanted) {
    const auto until = std::chrono::steady_clock::now() + std::chrono::milliseconds(wait_ms);
    for (;;) {
        const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(
            until - std::chrono::steady_clock::now());
        if (left.count() <= 0) return false;
        const Packet report = port.read(static_cast<int>(left.count()));
        if (wanted(report)) return true;
        if (report.empty() && !port.is_there()) return false;
    }
}

Error not_answering(const HidActuator& actuator) {
    return {actuator.name + " does not answer: disconnect it and connect it again"};
}

// The words of the cable. A pad that is awake already may leave them unanswered.
Expected<Done> wake_on_cable(const HidActuator& actuator, const HidPort& port) {
    constexpr int kNoTimeout = 0x04;  // is not answered
    for (const std::uint8_t command : kSwitchUsbCommands) {
        if (!port.write(switch_usb(command))) return not_answering(actuator);
        if (command == kNoTimeout) continue;
        comes(port, 100, [command](const Packet& report) {
            return report.size() >= 2 && report[0] == 0x81 && report[1] == command;
        });
    }
    return Done{};
}

Expected<Encoder> begin_switch(const HidActuator& actuator, const HidPort& port) {
    // The kernel's driver has done it all, and what is said to it on top would be answered to it.
    if (actuator.kernel_driver != "nintendo") {
        if (actuator.bus == HidBus::usb) {
            if (const auto awake = wake_on_cable(actuator, port); !awake) return awake.error();
        }
        bool enabled = false;
        for (int attempt = 0; attempt < 3 && !enabled; ++attempt) {
            if (!port.write(switch_subcommand(attempt, {}, kEnableVibration, 1))) break;
            enabled = comes(port, 250, [](const Packet& report) {
                return acknowledges(report, kEnableVibration);
            });
        }
        if (!enabled) return not_answering(actuator);
    }
    return Encoder(
        [](const RumbleFrame& frame, int counter) { return switch_rumble(counter, frame); });
}

// Feature report 0x20 names the firmware, its version at byte 44.
DualSenseRumble firmware_of(const HidPort& port) {
    const Packet report = port.feature(0x20, 63);
    if (report.size() < 46) return DualSenseRumble::before_2_24;
    const int version = report[44] | (report[45] << 8);
    return version >= 0x0224 ? DualSenseRumble::from_2_24 : DualSenseRumble::before_2_24;
}

Encoder sony_encoder(const HidActuator& actuator, const HidPort& port) {
    const bool by_air = actuator.bus == HidBus::bluetooth;
    if (actuator.kind == ActuatorKind::dualshock_4) {
        return [by_air](const RumbleFrame& frame, int) {
            return by_air ? dualshock4_bluetooth(frame) : dualshock4_usb(frame);
        };
    }
    return [by_air, firmware = firmware_of(port)](const RumbleFrame& frame, int counter) {
        return by_air ? dualsense_bluetooth(counter, frame, firmware)
                      : dualsense_usb(frame, firmware);
    };
}

Expected<Encoder> begin_simple_haptic(const HidActuator& actuator, const HidPort& port) {
    const std::optional<HapticPage> page = haptic_page(actuator.descriptor);
    if (!page) return Error{actuator.name + " does not say how it is asked to vibrate"};
    const Packet list = port.feature(page->waveform_report, page->waveform_bytes);
    const std::optional<int> waveform = continuous_waveform(*page, list);
    if (!waveform) {
        return Error{actuator.name + " has clicks only, and no lasting vibration"};
    }
    return Encoder([page = *page, waveform = *waveform](const RumbleFrame& frame, int) {
        return frame.low > 0.0 ? haptic_output(page, waveform, frame.low)
                               : haptic_output(page, kWaveformStop, 0.0);
    });
}

}  // namespace

Expected<Encoder> begin_protocol(const HidActuator& actuator, const HidPort& port) {
    switch (actuator.kind) {
        case ActuatorKind::joy_con:
        case ActuatorKind::switch_pro:
            return begin_switch(actuator, port);
        case ActuatorKind::dualshock_4:
        case ActuatorKind::dualsense:
            return sony_encoder(actuator, port);
        case ActuatorKind::simple_haptic:
            return begin_simple_haptic(actuator, port);
        case ActuatorKind::voice_coil:
        case ActuatorKind::phone_web:
            break;
    }
    return Error{actuator.name + " is no HID device"};
}

}  // namespace tact
