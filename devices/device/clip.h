// A drive signal as an output plays it: at the output's own rate, whole in memory.
//
// Input     a drive of -1..1 at any rate that model/signal/resample.h takes; what is no number, or
//           too large for one, is silence
// Output    one value a frame of the output, of full scale; never NaN or infinite
// Exact     the frames of a loop are those of the endless signal: its seam is resampled like the
//           rest.
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "devices/device/device.h"
#include "devices/device/ledger.h"

namespace tact {

struct Clip {
    std::vector<float> samples;
    float peak = 0.0F;           // of what a converter makes of the samples, between them too
    float largest_level = 1.0F;  // a level above it counts as this one
    bool loop = false;
    std::uint64_t serial = 0;  // of the play it was made for
    std::uint64_t longest_frames = std::numeric_limits<std::uint64_t>::max();  // then it fades
    bool waits = false;            // for the end of the clip before it, which is not cut off ...
    std::int64_t rest_frames = 0;  // ... and so long after that; below 0: before it
    double lead_s = 0.0;           // in it before the signal begins ...
    double tail_s = 0.0;           // ... and after it
    Load load{};
    double rms_limit = 0.0;  // over any second, what came before it too; 0: not known
    double rest_after_s = std::numeric_limits<double>::infinity();
    Travel travel{};
    double travel_from_s = 0.0;  // in the clip, where that begins
};

// The filter's ringing before a sudden start and after a sudden end belongs to the signal: without
// `loop` the clip is `kClipMarginS` longer at either end.
Clip clip_of(const Drive& drive, double rate_hz, bool loop);

// One whose signal begins `rest_s` after the end of the signal in `before`, to the frame. Where the
// tail of that and the lead of this are longer than the rest, both sound at once: peak and load are
// then those of both.
Clip clip_after(const Drive& drive, double rate_hz, double rest_s, const Clip& before);

inline constexpr double kClipMarginS = 0.01;

}  // namespace tact
