#include "app/timeline/playhead.h"

#include <algorithm>
#include <cmath>

namespace tact {

Playhead advanced(Playhead playhead, double elapsed_s, double duration_s) {
    if (!playhead.playing) return playhead;
    playhead.at_s += std::max(0.0, elapsed_s) * playhead.speed;
    if (playhead.at_s < duration_s) return playhead;
    if (playhead.loop && duration_s > 0.0) {
        playhead.at_s = std::fmod(playhead.at_s, duration_s);
    } else {
        playhead.at_s = duration_s;
        playhead.playing = false;
    }
    return playhead;
}

Playhead stepped(Playhead playhead, int steps, double duration_s) {
    // A playhead that stands on a step's start belongs to that step, whatever the rounding.
    const double own = std::floor(playhead.at_s / kStepS + 1e-6);
    const double last = std::max(0.0, std::ceil(duration_s / kStepS - 1e-6) - 1.0);
    playhead.at_s = std::clamp(own + steps, 0.0, last) * kStepS;
    playhead.playing = false;
    return playhead;
}

}  // namespace tact
