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

// What is known of a device before it is opened.

enum class DeviceKind { audio, hid, phone };

// A computer that is busy now and then for so long plays without gaps. A stop does not wait for it;
// a change of a loop does.
inline constexpr double kBufferS = 0.1;

struct DeviceInfo {
    // The same device has the same one tomorrow, at another port, after another card was put in.
    std::string id;
    DeviceKind kind = DeviceKind::audio;
    std::string name;
    std::string interface;              // that it is reached by: "ALSA", "JACK", "Bluetooth"
    std::vector<std::string> channels;  // their names; empty: it has none to choose from
    // A sound server takes any number of channels, and mixes those that its output lacks. If it
    // says which output that is, `channels` are that output's, in its order, and only it is played
    // on; otherwise a person has to know.
    bool is_server = false;
    std::string server_output{};  // empty: it does not say
    std::string output_name{};    // of that output, as a person knows it
    double rate_hz = 0.0;
    double latency_s = 0.0;
    std::string trouble;  // why it cannot play now: a sentence a person can act on

    bool operator==(const DeviceInfo&) const = default;
};

// "3, rear left"; the number alone where the channel has no other name. Channels count from 1.
inline std::string channel_text(const DeviceInfo& device, int channel) {
    const std::string number = std::to_string(channel);
    const auto at = static_cast<std::size_t>(channel - 1);
    if (at >= device.channels.size() || device.channels[at] == number) return number;
    return number + ", " + device.channels[at];
}

// What tells apart where the sound comes out: two devices of one place are two names of one output.
inline std::string place_of_sound(const DeviceInfo& device) {
    return device.server_output.empty() ? device.id : "server " + device.server_output;
}

// What a person has chosen of a device, to be remembered.
struct DeviceChoice {
    std::string id;  // empty: none
    int channel = 1;
    int of_channels = 0;  // of a sound server: as many as its outputs have; 0: 2, or enough
    double latency_offset_s = 0.0;  // felt so much later than the device says
    std::string calibration{};      // its file; empty: none
    bool everywhere = false;        // the same on all channels, as masking noise is
    double buffer_s = kBufferS;     // of an output: rendered ahead

    bool operator==(const DeviceChoice&) const = default;
};

}  // namespace tact
