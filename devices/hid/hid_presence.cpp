// Whether a controller is there: listed, unplugged, out of reach, back again.
#include <utility>

#include "devices/hid/hid_device.h"

namespace tact {

std::vector<DeviceInfo> controllers() {
    std::vector<DeviceInfo> devices;
    for (const HidActuator& actuator : hid_actuators()) {
        DeviceInfo info;
        info.id = lasting_id(actuator);
        info.kind = DeviceKind::hid;
        info.name = actuator.name;
        info.interface = actuator.bus == HidBus::bluetooth ? "Bluetooth" : "USB";
        info.latency_s = packet_period_s(actuator);
        if (const auto allowed = may_be_opened(actuator); !allowed) {
            info.trouble = allowed.error().message;
        }
        devices.push_back(std::move(info));
    }
    return devices;
}

Expected<std::unique_ptr<Device>> open_controller(const DeviceInfo& device) {
    for (HidActuator& actuator : hid_actuators()) {
        if (lasting_id(actuator) != device.id) continue;
        return std::unique_ptr<Device>(std::make_unique<HidDevice>(std::move(actuator)));
    }
    return Error{device.name + " is not there any more: connect it again"};
}

// The play is over. The port stays: what follows is to be said through it.
void HidDevice::fail(const std::string& why) {
    const bool there = ports_.may_be_opened(actuator_).operator bool();
    const std::lock_guard lock(mutex_);
    next_.reset();
    behind_.reset();
    status_.connected = there;
    status_.playing = false;
    status_.trouble = why;
}

void HidDevice::lose(const std::string& why) {
    port_.reset();
    fail(why);
}

// A controller that was lost while it vibrated keeps vibrating if it is out of reach, or if only
// its node changed meanwhile.
void HidDevice::put_to_rest(const std::stop_token& quit) {
    if (!port_ && !is_back()) return;
    const Expected<ActuatorLock> alone = ports_.claim(actuator_);
    // Whoever has it now drives it.
    if (!alone) owes_rest_ = false;
    if (alone && (port_ || ready())) end_in_silence(quit);
}

// Between plays: unplugged, or there again.
void HidDevice::watch() {
    bool connected = false;
    {
        const std::lock_guard lock(mutex_);
        connected = status_.connected;
    }
    if (port_ && !port_->is_there()) {
        return lose(actuator_.name + " was unplugged, or is out of reach");
    }
    if (connected || !is_back()) return;
    const std::lock_guard lock(mutex_);
    status_.connected = true;
    status_.trouble.clear();
}

// Perhaps as another node than before.
bool HidDevice::is_back() {
    for (const HidActuator& actuator : ports_.list()) {
        if (lasting_id(actuator) != lasting_id(actuator_)) continue;
        actuator_ = actuator;
        return ports_.may_be_opened(actuator_).operator bool();
    }
    return false;
}

}  // namespace tact
