// Signals on the time axis that all views share: scrubbed, zoomed and pointed at as one.
#pragma once

#include <span>
#include <string>

#include "app/document/workspace.h"
#include "app/timeline/timeline.h"
#include "app/ui/ui.h"
#include "viz/charts/wave_view.h"
#include "viz/drawing/geometry.h"

namespace tact {

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
