// Where in time the views look: one playhead, and one visible range that all time axes share.
//
// Left out  sound: while a device plays, its own clock moves the playhead.
#pragma once

#include "model/physiology/spike_train.h"

namespace tact {

// Seconds from the start of the pattern.
struct Playhead {
    double at_s = 0.0;
    double speed = 0.1;  // of real time: 1, 1/10, 1/100
    bool playing = false;
    bool loop = true;
};

struct TimeRange {
    double start_s = 0.0;
    double end_s = 0.0;

    double length_s() const { return end_s - start_s; }
    bool operator==(const TimeRange&) const = default;
};

inline constexpr double kShortestRangeS = kStepS;  // one step of the model fills the view

// `elapsed_s` of real time later. At the end it starts over, or stays there and stops.
Playhead advanced(Playhead playhead, double elapsed_s, double duration_s);

// To the start of the step that lies `steps` from the playhead's own, which stops.
Playhead stepped(Playhead playhead, int steps, double duration_s);

// The range `factor` times as long (below 1: closer), with `fixed_s` staying in its place on the
// screen; within 0..duration.
TimeRange zoomed(TimeRange range, double factor, double fixed_s, double duration_s);
TimeRange panned(TimeRange range, double by_s, double duration_s);

// The range for a pattern of this length: the whole of it where there was none, or where it would
// reach past the end.
TimeRange fitted(TimeRange range, double duration_s);

// The range turned like a page where the playhead has left it.
TimeRange followed(TimeRange range, double at_s, double duration_s);

}  // namespace tact
