#include "devices/device_list.h"

#include <algorithm>

#include "devices/audio/audio_device.h"
#include "devices/hid/hid_device.h"

namespace tact {

namespace {

// How many channels a stream to it has.
Expected<int> stream_channels(const DeviceInfo& device, const DeviceChoice& choice) {
    const auto most = static_cast<int>(device.channels.size());
    if (!device.is_server) return most;
    if (!device.server_output.empty()) {
        if (choice.of_channels == 0 || choice.of_channels == most) return most;
        return Error{device.name + " plays on \"" + device.server_output + "\", which has " +
                     std::to_string(most) + " channels, not " + std::to_string(choice.of_channels) +
                     ": it would mix them"};
    }
    if (choice.of_channels > 0) return std::min(choice.of_channels, most);
    // A server mixes what does not match its outputs: stereo does no harm, and more only on
    // request.
    return std::min(std::max(2, choice.channel + choice.channel % 2), most);
}

DeviceInfo info_of(const HidActuator& actuator) {
    DeviceInfo info;
    info.id = lasting_id(actuator);
    info.kind = DeviceKind::hid;
    info.name = actuator.name;
    info.interface = actuator.bus == HidBus::bluetooth ? "Bluetooth" : "USB";
    info.latency_s = packet_period_s(actuator);
    if (const auto allowed = may_be_opened(actuator); !allowed) {
        info.trouble = allowed.error().message;
    }
    return info;
}

Expected<std::unique_ptr<Device>> open_hid(const DeviceInfo& device) {
    for (HidActuator& actuator : hid_actuators()) {
        if (lasting_id(actuator) != device.id) continue;
        return std::unique_ptr<Device>(std::make_unique<HidDevice>(std::move(actuator)));
    }
    return Error{device.name + " is not there any more: connect it again"};
}

}  // namespace

std::vector<DeviceInfo> list_devices(AudioHost& host) {
    std::vector<DeviceInfo> devices = host.outputs();
    for (const HidActuator& actuator : hid_actuators()) devices.push_back(info_of(actuator));
    return devices;
}

Expected<std::unique_ptr<Device>> open_device(const std::shared_ptr<AudioHost>& host,
                                              const DeviceInfo& device,
                                              const DeviceChoice& choice) {
    if (device.kind == DeviceKind::hid) return open_hid(device);
    if (device.kind == DeviceKind::phone) {
        return Error{device.name + " are played on by whoever serves their page"};
    }
    const Expected<int> channels = stream_channels(device, choice);
    if (!channels) return channels.error();
    return open_audio(host, device, choice, *channels);
}

std::string advice_without_devices() {
    return "Plug in a voice coil on an amplifier at a sound output, or a game controller, and "
           "refresh.";
}

std::string cards_fault(const AudioHost& host) {
    if (!host.is_without_cards()) return {};
    return "Sound cards were not looked for, as ALSA has no configuration with a default output: "
           "install libasound2-data, or correct ALSA_CONFIG_PATH.";
}

}  // namespace tact
