// Playhead and time axes.
#pragma once

#include <optional>
#include <span>
#include <string>

#include "app/document/workspace.h"
#include "app/ui/ui.h"
#include "viz/charts/wave_view.h"
#include "viz/drawing/geometry.h"
#include "viz/drawing/plot.h"

namespace tact {

// Where in time the views look: one playhead.
//
// Left out  sound: while a device plays, its own clock moves the playhead.

// Seconds from the start of the pattern.
struct Playhead {
    double at_s = 0.0;
    double speed = 0.1;  // of real time: 1, 1/10, 1/100
    bool playing = false;
    bool loop = true;
};

// `elapsed_s` of real time later. At the end it starts over, or stays there and stops.
Playhead advanced(Playhead playhead, double elapsed_s, double duration_s);

// To the start of the step that lies `steps` from the playhead's own, which stops.
Playhead stepped(Playhead playhead, int steps, double duration_s);

// One time for all axes: the playhead, the range that is shown, and where it is pointed at.

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

// Signals on the time axis that all views share: scrubbed, zoomed and pointed at as one.

// One signal from time 0 on.
struct TimeRow {
    std::string id;  // names it for tests: "brain", "filtered FA1"
    std::span<const double> samples;
    double rate_hz = 10'000.0;
    ImU32 colour = 0;
    TraceStyle style = TraceStyle::line;
    double largest = 0.0;  // value at the upper edge; 0: the largest sample
    bool signed_values = true;
    const char* unit = "";
    bool large = false;      // with room for values at the left
    bool values = true;      // which stand there
    bool time_axis = false;  // with ticks below
    bool stale = false;
};

void draw_time_row(Ui& ui, const Workspace& work, Timeline& timeline, const Rect& area,
                   const TimeRow& row);

// What the mouse did on a time axis that spans `area`: moves the playhead, zooms (Ctrl and wheel),
// pans (wheel), and points at a time in all views.
struct TimeGesture {
    std::optional<double> hovered_s;
    std::optional<double> scrubbed_s;
};
void take_time_gesture(const Workspace& work, Timeline& timeline, const Rect& area,
                       const TimeGesture& gesture);

// Ticks and "s" along the top of the area, for a group of rows without ticks of their own.
float time_axis_height(const Ui& ui);

// Left of the curves in a large view, where values stand.
float value_room_px(const Ui& ui);

}  // namespace tact
