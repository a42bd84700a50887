// All devices of this computer, and how one of them is opened.
//
// Left out  which one is chosen, and remembering it: the program's.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "devices/audio/audio_host.h"
#include "devices/device/device.h"

namespace tact {

// Takes up to some seconds: not for a thread that draws.
std::vector<DeviceInfo> list_devices(AudioHost& host);

// The device with this id, then with this name, then the only one with these words in its name.
// Case does not matter. An Error names what there is.
Expected<DeviceInfo> find_device(const std::vector<DeviceInfo>& devices, const std::string& wanted);

// The channel of a number, counted from 1, or of a name ("left actuator"). An Error names them.
Expected<int> find_channel(const DeviceInfo& device, const std::string& wanted);

// Does not wait, and never answers with another device: whether it can be opened shows at the first
// play, in the status. An Error if the choice does not fit the device.
Expected<std::unique_ptr<Device>> open_device(const std::shared_ptr<AudioHost>& host,
                                              const DeviceInfo& device, const DeviceChoice& choice);

// Calls `changed`, on the thread that draws and until the program ends, whenever devices have come
// or gone by themselves, where the system says so: a browser does, of controllers.
void watch_devices(std::function<void()> changed);

// What to do where there is no device at all: a sentence or two.
std::string advice_without_devices();

// Why no sound card could be looked for: a sentence; empty: they were.
std::string cards_fault(const AudioHost& host);

}  // namespace tact
