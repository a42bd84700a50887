// Signals over time: a waveform in g, or an envelope, with the playhead.
//
// Input     samples from time 0 on; the visible range of time and of values
// Output    time and value under the mouse, and the new place of a dragged playhead
// Left out  zooming (the caller's range), several panes (call it several times).
#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "viz/drawing/plot.h"

namespace tact {

struct WaveTrace {
    std::span<const double> samples{};
    double rate_hz = 10'000.0;
    ImU32 colour = 0;
    TraceStyle style = TraceStyle::line;
};

struct WaveScene {
    std::span<const WaveTrace> traces{};  // drawn in this order; the read-out is that of the last
                                          // one
    double start_s = 0.0;
    double end_s = 1.0;
    double largest = 0.0;       // value at the upper edge; 0: the largest sample of all traces
    bool signed_values = true;  // zero in the middle, or at the bottom
    std::string_view unit = "g";
    bool time_axis = true;  // with ticks; false for all but the lowest of several
    bool value_axis = true;
    float left_room_px = 0.0F;  // least room left of the curve, so that axes above each other align
    std::optional<double> playhead_s{};
    std::optional<double> crosshair_s{};  // time under the mouse in another plot
    bool stale = false;
};

struct WaveAction {
    std::optional<double> hovered_s{};
    std::optional<std::size_t> hovered_sample{};  // value of the last trace
    std::optional<double> scrubbed_s{};  // the mouse is held down: the playhead's new place
};

// `id` names the view among its window's widgets.
WaveAction draw_wave(const char* id, const Theme& theme, const Rect& area, const WaveScene& scene);

// The largest absolute value over all traces, the meaning of `largest` = 0 (1 for silence).
double largest_value(std::span<const WaveTrace> traces);

}  // namespace tact
