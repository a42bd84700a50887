// Where the tour is, and what it turns to its own ends.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "app/physiology/stages.h"
#include "app/timeline/playhead.h"
#include "app/ui/layout.h"

namespace tact {

// What the tour turns to its own ends, as it was.
struct ViewBeforeTour {
    Layout layout;
    std::size_t current = 0;
    std::string pinned;
    Playhead playhead;
    TimeRange time_range;
    std::optional<Stage> open;
};

struct TourState {
    std::optional<std::size_t> step;  // under way
    std::size_t left_at = 0;          // where to take it up again
    ViewBeforeTour before;
};

}  // namespace tact
