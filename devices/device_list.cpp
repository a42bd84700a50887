#include "devices/device_list.h"

#include <algorithm>
#include <cctype>
#include <charconv>

#include "devices/audio/audio_device.h"
#include "devices/hid/hid_device.h"

namespace tact {

namespace {

std::string lower(std::string text) {
    for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return text;
}

std::string quoted_list(const std::vector<std::string>& names) {
    std::string list;
    for (const std::string& name : names) list += (list.empty() ? "\"" : ", \"") + name + "\"";
    return list;
}

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

Expected<DeviceInfo> find_device(const std::vector<DeviceInfo>& devices,
                                 const std::string& wanted) {
    if (devices.empty()) return Error{"there is no device. " + advice_without_devices()};
    const std::string text = lower(wanted);
    std::vector<const DeviceInfo*> found;
    for (const DeviceInfo& device : devices) {
        if (lower(device.id) == text) return device;
        if (lower(device.name) == text)
            found.insert(found.begin(), &device);
        else if (lower(device.name).find(text) != std::string::npos)
            found.push_back(&device);
    }
    const bool is_exact = !found.empty() && lower(found.front()->name) == text &&
                          (found.size() == 1 || lower(found[1]->name) != text);
    if (found.size() == 1 || is_exact) return *found.front();
    std::vector<std::string> names;
    for (const DeviceInfo& device : devices) names.push_back(device.id);
    return Error{(found.empty() ? "no device is called \"" : "several devices are called \"") +
                 wanted + "\"; there are " + quoted_list(names)};
}

Expected<int> find_channel(const DeviceInfo& device, const std::string& wanted) {
    const auto count = static_cast<int>(device.channels.size());
    if (count == 0) return Error{device.name + " has no channels to choose from"};
    int number = 0;
    const char* end = wanted.data() + wanted.size();
    const auto read = std::from_chars(wanted.data(), end, number);
    if (read.ec == std::errc() && read.ptr == end && number >= 1 && number <= count) return number;
    for (int channel = 0; channel < count; ++channel) {
        const std::string& name = device.channels[static_cast<std::size_t>(channel)];
        if (lower(name) == lower(wanted)) return channel + 1;
    }
    return Error{device.name + " has no channel \"" + wanted + "\": expected 1 to " +
                 std::to_string(count) + ", or one of " + quoted_list(device.channels)};
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
    if (choice.channel < 1 || choice.channel > *channels) {
        return Error{device.name + " has no channel " + std::to_string(choice.channel) +
                     ": expected 1 to " + std::to_string(*channels)};
    }
    AudioStream::Place place;
    place.id = device.id;
    place.name = device.name;
    place.channel = static_cast<std::size_t>(choice.channel - 1);
    place.channels = static_cast<std::size_t>(*channels);
    place.buffer_s = choice.buffer_s;
    place.latency_offset_s = choice.latency_offset_s;
    place.everywhere = choice.everywhere;
    place.server_output = device.server_output;
    return std::unique_ptr<Device>(std::make_unique<AudioDevice>(host, std::move(place)));
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
