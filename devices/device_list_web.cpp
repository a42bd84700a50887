#include <algorithm>
#include <iterator>
#include <utility>

#include "devices/audio/audio_device.h"
#include "devices/device_list.h"
#include "devices/hid/hid_device.h"
#include "devices/phone/phone_device.h"

// In phone/web_vibration.js.
extern "C" {
int web_vibrates();  // whether the page is on a phone whose browser can
void web_vibrate(const int* ms, int count, int loop);
}

namespace tact {

namespace {

Expected<std::unique_ptr<Device>> open_this_phone() {
    PhoneDoor door;
    door.play = [](const PhonePlay& play) {
        web_vibrate(play.ms.data(), static_cast<int>(play.ms.size()), play.loop ? 1 : 0);
    };
    ConnectedPhone phone;
    phone.vibrates = phone.is_here = true;
    door.phones = [phone] { return std::vector{phone}; };
    door.has_thread = false;
    return std::unique_ptr<Device>(std::make_unique<PhoneDevice>(std::move(door)));
}

}  // namespace

std::vector<DeviceInfo> list_devices(AudioHost& host) {
    std::vector<DeviceInfo> devices = host.outputs();
    if (web_vibrates() != 0) devices.push_back(phone_info(kThisPhoneId, "This phone"));
    std::ranges::copy(controllers(), std::back_inserter(devices));
    return devices;
}

Expected<std::unique_ptr<Device>> open_device(const std::shared_ptr<AudioHost>& host,
                                              const DeviceInfo& device,
                                              const DeviceChoice& choice) {
    if (device.id == kThisPhoneId) return open_this_phone();
    if (device.kind == DeviceKind::hid) return open_controller(device);
    return open_audio(host, device, choice, static_cast<int>(device.channels.size()));
}

std::string advice_without_devices() { return "A voice coil plays at the sound output."; }

void watch_devices(std::function<void()> changed) { watch_hid_nodes(std::move(changed)); }

std::string cards_fault(const AudioHost&) { return {}; }

}  // namespace tact
