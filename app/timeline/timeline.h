// One time for all axes: the playhead, the range that is shown, and where it is pointed at.
#pragma once

#include <optional>

#include "app/timeline/playhead.h"

namespace tact {

struct Timeline {
    Playhead playhead;
    std::optional<double> crosshair_s;       // where any time axis is pointed at in this frame
    std::optional<double> crosshair_last_s;  // and was in the last
    TimeRange range;                         // of every time axis; of no length: the whole pattern
};

}  // namespace tact
