#include "devices/device_list.h"

#include <algorithm>
#include <iterator>

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

}  // namespace

std::vector<DeviceInfo> list_devices(AudioHost& host) {
    std::vector<DeviceInfo> devices = host.outputs();
    std::ranges::copy(controllers(), std::back_inserter(devices));
    return devices;
}

Expected<std::unique_ptr<Device>> open_device(const std::shared_ptr<AudioHost>& host,
                                              const DeviceInfo& device,
                                              const DeviceChoice& choice) {
    if (device.kind == DeviceKind::hid) return open_controller(device);
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

void watch_devices(std::function<void()>) {}

std::string cards_fault(const AudioHost& host) {
    if (!host.is_without_cards()) return {};
    return "Sound cards were not looked for, as ALSA has no configuration with a default output: "
           "install libasound2-data, or correct ALSA_CONFIG_PATH.";
}

}  // namespace tact
