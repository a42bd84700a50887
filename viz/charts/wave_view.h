// Signals over time: a waveform in g, or an envelope, with the playhead.
//
// Input     samples from time 0 on; the visible range of time and of values
// Output    what the mouse points at, and where it drags the playhead to
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
    std::span<const WaveTrace> traces{};  // drawn in this order; the read-out is of the last one
    double start_s = 0.0;
    double end_s = 1.0;
    double largest = 0.0;       // value at the upper edge; 0: the largest sample of all traces
    bool signed_values = true;  // zero in the middle, or at the bottom
    std::string_view unit = "g";
    bool time_axis = true;  // with ticks; false for all but the lowest of several
    bool value_axis = true;
    float left_room_px = 0.0F;  // at least so much left of the curve: axes above each other agree
    std::optional<double> playhead_s{};
    std::optional<double> crosshair_s{};  // where another time axis is pointed at
    bool stale = false;
};

struct WaveAction {
    std::optional<double> hovered_s{};
    std::optional<std::size_t> hovered_sample{};  // of the last trace
    std::optional<double> scrubbed_s{};  // the mouse is held down: the playhead's new place
};

// `id` names the view among its window's widgets.
WaveAction draw_wave(const char* id, const Theme& theme, const Rect& area, const WaveScene& scene);

// The largest absolute value over all traces; what `largest` = 0 stands for (1 for silence).
double largest_value(std::span<const WaveTrace> traces);

}  // namespace tact
