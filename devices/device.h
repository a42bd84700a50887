// The one interface of the program: something that plays a waveform.
//
// Input     a waveform in g; a device resamples and scales it to what it is
// Left out  which devices there are: audio and HID actuators join this room as files of their own.
#pragma once

#include <string>

#include "model/expected.h"
#include "model/waveform.h"

namespace tact {

struct DeviceStatus {
    std::string name;
    bool connected = false;
    bool playing = false;
    double position_s = 0.0;  // in the waveform being played

    bool operator==(const DeviceStatus&) const = default;
};

class Device {
  public:
    virtual ~Device() = default;

    // Starts from the beginning, in place of what was playing. An Error says what to plug in.
    virtual Expected<Done> play(const Waveform& waveform) = 0;
    virtual void stop() = 0;
    virtual DeviceStatus status() const = 0;
};

}  // namespace tact
