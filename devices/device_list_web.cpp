#include "devices/device_list.h"

namespace tact {

std::vector<DeviceInfo> list_devices(AudioHost& host) { return host.outputs(); }

Expected<std::unique_ptr<Device>> open_device(const std::shared_ptr<AudioHost>&,
                                              const DeviceInfo& device, const DeviceChoice&) {
    return Error{device.name + " cannot be played on from a browser"};
}

std::string advice_without_devices() {
    return "In a browser there is no device to play on: install tactspace to play on voice coils "
           "and controllers.";
}

std::string cards_fault(const AudioHost&) { return {}; }

}  // namespace tact
