// Which of the devices somebody means.
#include <algorithm>
#include <cctype>
#include <charconv>

#include "devices/device_list.h"

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

}  // namespace

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

}  // namespace tact
