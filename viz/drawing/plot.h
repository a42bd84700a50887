// Axes, ticks, grids, read-outs and long signals: what every plot over time or frequency shares.
//
// Left out  second axes, legends (label curves directly), panning and zooming (the caller's range).
#pragma once

#include <imgui.h>

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "model/physiology/spike_train.h"
#include "viz/drawing/geometry.h"
#include "viz/drawing/theme.h"

namespace tact {

enum class Scale { linear, logarithmic };

// A range of values along a range of pixels (either may run backwards).
struct Axis {
    double low = 0.0;
    double high = 1.0;
    Scale scale = Scale::linear;  // logarithmic needs low, high > 0
    float low_px = 0.0F;
    float high_px = 1.0F;
};

float to_pixel(const Axis& axis, double value);
double to_value(const Axis& axis, float pixel);

// 3-5 round values inside the range: steps of 1, 2, 2.5 or 5 times a power of ten; on a logarithmic
// axis decades, or 1-3, or 1-2-5. Empty if low >= high or a bound is not finite.
std::vector<double> round_ticks(double low, double high, Scale scale = Scale::linear);

// The ticks of an axis that leave `apart_px` between neighbours: all, or every second one (zero
// among them where it is one), or every fourth ...
std::vector<double> ticks_apart(const Axis& axis, float apart_px);

// "0.25", "-40", "1000"; as many decimals as the value needs, at most 6 significant digits.
std::string tick_text(double value);

// The same with the digits that tell it from its neighbours a step away: "59.8925" of steps of
// 0.0025.
std::string tick_text(double value, double step);

// With the decimals that a step takes, on all values alike: "59.90", "59.91" of steps of 0.01.
std::string stepped(double value, double step);

// A place on an axis as a read-out says it: to about a five-hundredth of what is in view.
std::string place_text(const Axis& axis, double value);

// Where the curves go, and the axes that span it.
struct Plot {
    Rect outer;  // with the labels
    Rect area;
    Axis x;
    Axis y;
};

struct PlotLabels {
    std::string_view x_unit;  // after the last tick: "Hz"; empty: no ticks along x
    std::string_view y_unit;
    bool y_grid = true;
};

// The area inside `outer` that leaves room for tick labels.
Plot plot_within(const Rect& outer, const Theme& theme, Axis x, Axis y, const PlotLabels& labels);

// Light horizontal grid with its values left of the area, ticks below it, units at the ends.
void draw_axes(ImDrawList& list, const Theme& theme, const Plot& plot, const PlotLabels& labels);

// The line at y = 0, if it is in range.
void draw_zero_line(ImDrawList& list, const Theme& theme, const Plot& plot);

// A 1 px vertical line at x: the playhead in the accent colour, a crosshair dim.
void draw_cursor_line(ImDrawList& list, const Theme& theme, const Plot& plot, double x,
                      ImU32 colour);

// Smallest and largest sample of one pixel column.
struct Extremes {
    double low = 0.0;
    double high = 0.0;

    bool operator==(const Extremes&) const = default;
};

// The samples [first, last) shared out to `columns` equal columns. Each column also has the sample
// before it, so that neighbours touch and a steep flank is drawn whole. Columns that fall between
// samples repeat the nearest. Empty range or no columns: empty.
std::vector<Extremes> extremes(std::span<const double> samples, double first, double last,
                               std::size_t columns);

enum class TraceStyle {
    line,   // a waveform
    filled  // an envelope: from zero to the value
};

// Samples at x = i / rate, clipped to the area: a polyline while samples are far apart, one
// extremes column a pixel beyond that.
void draw_signal(ImDrawList& list, const Theme& theme, const Plot& plot,
                 std::span<const double> samples, double rate_hz, ImU32 colour, TraceStyle style);

// The part of a pattern's time that is in view.

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
