// One output of a PulseAudio server, or of PipeWire in its place: that one by its name, with the
// channels that it has, in its own order, and at its own rate. Hence nothing is mixed or resampled
// on the way, whatever the map of its channels says.
//
// The server must not move the stream: when the output goes, the stream ends with it, and nothing
// of it is heard elsewhere. A gap is one where the server had nothing to play, and says so. A stop
// writes a fade and silence over what the server has not played yet, however much that is: it is
// heard kTakenBackS later.
//
// Source    libpulse's asynchronous API, on a thread of its own
// Left out  outputs that the server cannot take anything back from, as some through the air: there
//           the fade comes when what they have is played; starting a server; waiting for an output
//           that is not there.
#pragma once

#include "devices/audio/output_port.h"
#include "devices/audio/sound_server.h"
#include "devices/device/playback.h"
#include "model/common/expected.h"

namespace tact {

inline constexpr double kTakenBackS = 0.008;

// `playback`, laid out for this output before, lives as long as the port. `buffer_s` is rendered
// ahead. An Error if the server does not take exactly this stream. Waits for up to two seconds.
Expected<OutputPort> open_pulse_output(const ServerOutput& output, double buffer_s,
                                       Playback& playback);

}  // namespace tact
