// One time for all axes: the playhead, the range that is shown, and where it is pointed at.
#pragma once

#include <optional>

#include "app/timeline/playhead.h"

namespace tact {

struct Timeline {
    Playhead playhead;
    std::optional<double> crosshair_s;       // where any time axis is pointed at in this frame
    std::optional<double> crosshair_last_s;  // and was in the last
    TimeRange
        range;  // of every time axis, as chosen; of no length: the whole pattern, however long
};

// What the time axes show of a pattern of this length.
inline TimeRange shown_range(const Timeline& timeline, double duration_s) {
    return fitted(timeline.range, duration_s);
}

inline bool is_zoomed_in(const Timeline& timeline, double duration_s) {
    return unless_whole(timeline.range, duration_s).length_s() > 0.0;
}

}  // namespace tact
