// The one or two sines that are most like a vibration at a moment: what an actuator with two
// bands of its own, as HD rumble has, can be asked for.
//
// Around the middle of a frame the signal is fitted with two sines under a Hann window of 50 ms, or
// of 100 ms where that fits much better (devices/rumble/sine_fit.h). Silence within the window is
// left out of the fit, so that notes begin and end with the frame they begin and end in, and at
// their full strength.
//
// Input     a drive signal, -1..1
// Output    amplitudes as shares of full scale; `share_lost` of the energy under the window
// Valid     steady tones that are at least 12 Hz apart: frequency to 1 %, amplitude to 2 %.
//           Closer ones are taken for one tone that swells and fades.
// Left out  phases: the actuator chooses its own. More than two tones at a time; content below
//           20 Hz.
// Exact     a frame depends on the signal around it alone.
#pragma once

#include <cstddef>

#include "devices/device/device.h"
#include "devices/rumble/rumble_packets.h"

namespace tact {

struct TrackedFrame {
    RumbleFrame rumble;
    double energy = 0.0;      // mean square of the signal under the window
    double share_lost = 0.0;  // of it, that the frame's sines are not
    bool folded = false;      // a tone below the low band plays as swells of 160 Hz instead
    bool noise = false;       // no tones: each band plays its level at the middle of its spectrum

    bool operator==(const TrackedFrame&) const = default;
};

// Frames that follow each other by `hop_s`, from the signal's beginning to its end.
std::size_t frame_count(const Drive& drive, double hop_s);

// Frame k: the signal from k hop_s on, for hop_s.
TrackedFrame tracked_frame(const Drive& drive, std::size_t k, double hop_s);

}  // namespace tact
