// What takes sound at a JACK server, and one channel of it open: our own client of JACK's, as
// PortAudio's ends the program where a server is killed and started again, and tells latencies
// instead of gaps.
//
// A gap is a cycle that passed without this program's part in it. JACK itself tells every program
// of the lateness of any.
//
// Source    libjack; its callbacks run on threads of its own
// Left out  starting a server; what other programs connect our port to.
#pragma once

#include <string>
#include <vector>

#include "devices/audio/output_port.h"
#include "devices/device/playback.h"
#include "model/common/expected.h"

namespace tact {

struct JackOutput {
    std::string client;              // "system": what its ports' names begin with
    std::vector<std::string> ports;  // that take sound, in JACK's order
    double rate_hz = 48'000.0;
    double latency_s = 0.0;  // of the first port
};

// The outputs at the usual server, or none where it does not answer.
std::vector<JackOutput> jack_outputs();

// Connected to these ports alone, the same to each, until one goes. Lays out `playback`, which
// lives as long as the port, for one channel. An Error says what JACK does not do.
Expected<OutputPort> open_jack_output(const std::vector<std::string>& ports, Playback& playback);

}  // namespace tact
