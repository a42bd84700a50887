// A drive signal as an output plays it: at the output's own rate, whole in memory.
//
// Input     a drive of -1..1 at any rate that model/signal/resample.h takes; what is no number is
// silence Output    one value a frame of the output, of full scale; never NaN Exact     the frames
// of a loop are those of the endless signal: its seam is resampled like the
//           rest.
#pragma once

#include <cstdint>
#include <vector>

#include "devices/device/device.h"

namespace tact {

struct Clip {
    std::vector<float> samples;
    float peak = 0.0F;
    bool loop = false;
    std::uint64_t serial = 0;  // of the play it was made for
};

// The filter's ringing before a sudden start and after a sudden end belongs to the signal: without
// `loop` the clip is `kClipMarginS` longer at either end.
Clip clip_of(const Drive& drive, double rate_hz, bool loop);

inline constexpr double kClipMarginS = 0.01;

}  // namespace tact
