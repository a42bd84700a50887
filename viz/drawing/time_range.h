// The part of a pattern's time that is in view.
#pragma once

#include "model/physiology/spike_train.h"

namespace tact {

struct TimeRange {
    double start_s = 0.0;
    double end_s = 0.0;

    double length_s() const { return end_s - start_s; }
    bool operator==(const TimeRange&) const = default;
};

inline constexpr double kShortestRangeS = kStepS;  // one step of the model fills the view

// The range `factor` times as long (below 1: closer), with `fixed_s` staying in its place on the
// screen; within 0..duration.
TimeRange zoomed(TimeRange range, double factor, double fixed_s, double duration_s);
TimeRange panned(TimeRange range, double by_s, double duration_s);

// The range for a pattern of this length: the whole of it if `range` is empty, or would reach past
// the end.
TimeRange fitted(TimeRange range, double duration_s);

// The range as a state: of no length where the whole is in view, so that it is the whole of the
// next pattern, too.
TimeRange unless_whole(TimeRange range, double duration_s);

// The range turned like a page where the playhead has left it.
TimeRange followed(TimeRange range, double at_s, double duration_s);

}  // namespace tact
