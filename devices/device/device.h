// The one interface of the program: something that plays a waveform.
//
// Input     a drive signal; devices/calibration/calibration.h makes one from a waveform in g
// Left out  which devices there are, and which one a person has chosen: the program's.
#pragma once

#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "devices/device/travel.h"
#include "model/common/expected.h"
#include "model/common/units.h"

namespace tact {

// What a device is told to do, as a share of its full scale: -1..1.
struct Drive {
    double rate_hz = kModelRateHz;
    std::vector<double> samples;
    double largest_level =
        1.0;  // a level above it counts as this one: more would harm the actuator
    double longest_s = std::numeric_limits<double>::infinity();  // on end; then it fades
    double rms_limit = 0.0;  // of full scale over any second, others' plays too; 0: not known
    // Driving, less the rests between, after which it fades (devices/device/ledger.h).
    double rest_after_s = std::numeric_limits<double>::infinity();
    double lead_s = 0.0;  // in it before what is meant begins ...
    double tail_s = 0.0;  // ... and after it
    Travel travel{};      // how far it moves the actuator, where a limit of that is known

    bool operator==(const Drive&) const = default;
};

struct DeviceStatus {
    std::string name;
    bool connected = false;
    bool playing = false;
    double position_s = 0.0;     // in the pattern, as it is felt now: latency is taken off
    double peak = 0.0;           // of full scale, since the last status
    bool clipped = false;        // the limiter has held this play back somewhere
    double kept = 1.0;           // least share of its level that plays before it have left
    bool is_warm = false;        // it ended as the actuator was driven for long with few rests
    std::uint64_t dropouts = 0;  // gaps in this play: the computer was too slow
    std::string trouble;         // why it stopped by itself: a sentence a person can act on

    bool operator==(const DeviceStatus&) const = default;
};

class Device {
  public:
    virtual ~Device() = default;

    // Starts `drive` from the beginning, in place of what was playing; `loop`: until stopped. An
    // Error says what to plug in or to allow.
    virtual Expected<Done> play(const Drive& drive, bool loop) = 0;
    // Starts `drive` so long after the end of what plays, or has played last: a pause is the
    // device's own, to the sample or the packet. Where that time is over, at once. What plays is
    // not cut off; its end is told by one status that plays no more before the next ones are of
    // `drive`.
    virtual Expected<Done> play_after(const Drive& drive, double rest_s) = 0;
    // What plays over and over becomes `drive` from where it is in it, without a step and without a
    // new start; if that has ended, nothing happens. Devices differ in how soon: an output fades
    // one into the other (devices/device/playback.h), a controller is told with its next packet.
    virtual void change(const Drive& drive) = 0;
    // How strong, as a share of the drive signal: 0 is silence, 1 all of it; what is no number is
    // 0. Also while playing.
    virtual void set_level(double level) = 0;
    virtual void stop() = 0;
    virtual DeviceStatus status() = 0;
};

}  // namespace tact
