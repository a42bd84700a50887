// What is known of a device before it is opened.
#pragma once

#include <string>
#include <vector>

namespace tact {

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
