#include "viz/drawing/plot.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "model/text/numbers.h"
#include "viz/drawing/colour.h"
#include "viz/drawing/marks.h"

namespace tact {

namespace {

constexpr std::size_t kFewestTicks = 3;
constexpr std::size_t kMostTicks = 5;

bool few_enough(std::size_t count) { return count >= kFewestTicks && count <= kMostTicks; }

std::vector<double> multiples_of(double step, double low, double high) {
    std::vector<double> ticks;
    const double slack = step * 1e-9;  // a bound that is a multiple but for rounding counts
    for (double k = std::ceil((low - slack) / step); k * step <= high + slack; k += 1.0) {
        ticks.push_back(k == 0.0 ? 0.0 : k * step);  // no minus zero
    }
    return ticks;
}

std::vector<double> linear_ticks(double low, double high) {
    // From fine to coarse: the finest step that gives no more than five.
    const double decade = std::pow(10.0, std::floor(std::log10((high - low) / 10.0)));
    std::vector<double> ticks;
    for (const double factor : {1.0, 2.0, 2.5, 5.0, 10.0, 20.0}) {
        ticks = multiples_of(factor * decade, low, high);
        if (few_enough(ticks.size())) break;
    }
    return ticks;
}

std::vector<double> logarithmic_ticks(double low, double high) {
    const int first = static_cast<int>(std::floor(std::log10(low)));
    const int last = static_cast<int>(std::ceil(std::log10(high)));
    const std::array<std::vector<double>, 3> mantissas{std::vector<double>{1.0},
                                                       std::vector<double>{1.0, 3.0},
                                                       std::vector<double>{1.0, 2.0, 5.0}};
    for (const auto& mantissa : mantissas) {
        // More than five decades: every second one, or third ...
        const int stride = std::max(1, (last - first + 4) / 5);
        std::vector<double> ticks;
        for (int exponent = first; exponent <= last; exponent += stride) {
            for (const double m : mantissa) {
                const double tick = m * std::pow(10.0, exponent);
                if (tick >= low * (1 - 1e-9) && tick <= high * (1 + 1e-9)) ticks.push_back(tick);
            }
        }
        if (few_enough(ticks.size())) return ticks;
    }
    return linear_ticks(low, high);
}

// 1, 2, 2.5 or 5 times a power of ten, of a positive value.
double round_below(double value) {
    const double decade = std::pow(10.0, std::floor(std::log10(value)));
    for (const double factor : {5.0, 2.5, 2.0}) {
        if (factor * decade <= value) return factor * decade;
    }
    return decade;
}

// Along y, where numbers stand above each other: a low plot around zero has that and one more.
std::vector<double> level_ticks(const Axis& axis, float text_px) {
    std::vector<double> ticks = ticks_apart(axis, 1.4F * text_px);
    const bool around_zero = axis.scale == Scale::linear && axis.low <= 0.0 && axis.high > 0.0;
    if (ticks.size() > 1 || !around_zero || !std::isfinite(axis.high)) return ticks;
    const double high = round_below(axis.high);
    const float apart_px = std::abs(to_pixel(axis, high) - to_pixel(axis, 0.0));
    return apart_px < text_px ? ticks : std::vector<double>{0.0, high};
}

// What lies between ticks; of a logarithmic axis none is asked for.
double step_between(const Axis& axis, std::span<const double> ticks) {
    return axis.scale == Scale::linear && ticks.size() > 1 ? ticks[1] - ticks[0] : 0.0;
}

}  // namespace

float to_pixel(const Axis& axis, double value) {
    double t = 0.0;
    if (axis.scale == Scale::logarithmic) {
        t = std::log(value / axis.low) / std::log(axis.high / axis.low);
    } else {
        t = (value - axis.low) / (axis.high - axis.low);
    }
    return axis.low_px + static_cast<float>(t) * (axis.high_px - axis.low_px);
}

double to_value(const Axis& axis, float pixel) {
    const double t =
        static_cast<double>(pixel - axis.low_px) / static_cast<double>(axis.high_px - axis.low_px);
    if (axis.scale == Scale::logarithmic) return axis.low * std::pow(axis.high / axis.low, t);
    return axis.low + t * (axis.high - axis.low);
}

std::vector<double> round_ticks(double low, double high, Scale scale) {
    if (!std::isfinite(low) || !std::isfinite(high) || low >= high) return {};
    // Bounds apart by rounding alone have no numbers between them to stop at.
    if (high - low <= 1e-12 * std::max(std::abs(low), std::abs(high))) return {};
    if (scale == Scale::logarithmic && low > 0.0) return logarithmic_ticks(low, high);
    return linear_ticks(low, high);
}

std::string tick_text(double value) { return with_true_minus(significant_digits(value, 6)); }

std::string tick_text(double value, double step) {
    const double steps = step > 0.0 ? std::abs(value) / step : 0.0;
    // Steps of 2.5 take a digit more.
    const int digits = steps > 1.0 ? static_cast<int>(std::ceil(std::log10(steps))) + 2 : 6;
    return with_true_minus(significant_digits(value, std::clamp(digits, 6, 15)));
}

std::string stepped(double value, double step) {
    const double decimals = step > 0.0 ? std::ceil(-std::log10(step) - 1e-9) : 0.0;
    return with_true_minus(fixed_digits(value, static_cast<int>(std::clamp(decimals, 0.0, 12.0))));
}

std::string place_text(const Axis& axis, double value) {
    return stepped(value, std::abs(axis.high - axis.low) / 500.0);
}

std::vector<double> ticks_apart(const Axis& axis, float apart_px) {
    std::vector<double> ticks = round_ticks(axis.low, axis.high, axis.scale);
    while (ticks.size() > 2 &&
           std::abs(to_pixel(axis, ticks[1]) - to_pixel(axis, ticks[0])) < apart_px) {
        const auto zero = std::find(ticks.begin(), ticks.end(), 0.0);
        const auto offset = zero == ticks.end() ? 0 : (zero - ticks.begin()) % 2;
        std::vector<double> kept;
        for (auto i = static_cast<std::size_t>(offset); i < ticks.size(); i += 2) {
            kept.push_back(ticks[i]);
        }
        ticks = std::move(kept);
    }
    return ticks;
}

Plot plot_within(const Rect& outer, const Theme& theme, Axis x, Axis y, const PlotLabels& labels) {
    const float text_px = font_or_current(theme.fonts.small).FontSize;
    Plot plot{outer, outer, x, y};
    if (labels.y_grid) {
        float widest = 0.0F;
        const std::vector<double> ticks = round_ticks(y.low, y.high, y.scale);
        for (const double tick : ticks) {
            const std::string text = tick_text(tick, step_between(y, ticks));
            widest = std::max(widest, text_size(theme.fonts.small, text).x);
        }
        plot.area.min.x += widest + theme.gap_px;
        plot.area.min.y += text_px * 0.5F;
        if (!labels.y_unit.empty()) plot.area.min.y += 0.9F * text_px;
    }
    if (!labels.x_unit.empty()) plot.area.max.y -= text_px + theme.gap_px * 0.75F;
    plot.x.low_px = plot.area.min.x;
    plot.x.high_px = plot.area.max.x;
    plot.y.low_px = plot.area.max.y;
    plot.y.high_px = plot.area.min.y;
    return plot;
}

void draw_axes(ImDrawList& list, const Theme& theme, const Plot& plot, const PlotLabels& labels) {
    const ImFont* font = theme.fonts.small;
    const float text_px = font_or_current(font).FontSize;
    const Rect& area = plot.area;
    if (labels.y_grid) {
        const float right = area.min.x - theme.gap_px * 0.75F;
        const std::vector<double> ticks = level_ticks(plot.y, text_px);
        std::optional<float> below;  // a low plot has room for one number
        for (const double tick : ticks) {
            const float y = to_pixel(plot.y, tick);
            if (below && std::abs(*below - y) < text_px) continue;
            below = y;
            draw_level_line(list, y, area.min.x, area.max.x, theme.hairline_px,
                            faded(theme.line, 0.7F));
            const std::string text = tick_text(tick, step_between(plot.y, ticks));
            const ImVec2 corner{right - text_size(font, text).x, y - text_px * 0.55F};
            draw_text(list, font, corner, theme.dim_text, text);
        }
        // Above the highest number, flush with the numbers or, if it is longer, with the edge.
        const float left = std::max(plot.outer.min.x, right - text_size(font, labels.y_unit).x);
        draw_text(list, font, {left, plot.outer.min.y - 0.15F * text_px}, theme.dim_text,
                  labels.y_unit);
    }
    if (labels.x_unit.empty()) return;
    const auto ticks = ticks_apart(plot.x, 4.0F * text_px);
    // From the last one, which has the unit: it may have to stand where the one before it would.
    float next_left = std::numeric_limits<float>::infinity();
    for (std::size_t i = ticks.size(); i-- > 0;) {
        std::string text = tick_text(ticks[i], step_between(plot.x, ticks));
        const float number_px = text_size(font, text).x;
        if (i + 1 == ticks.size()) text += " " + std::string{labels.x_unit};
        const float x = to_pixel(plot.x, ticks[i]);
        const float most_left =
            std::min(x - number_px / 2.0F, area.max.x - text_size(font, text).x);
        const float left = std::max(plot.outer.min.x, most_left);
        draw_upright_line(list, x, area.max.y, area.max.y + 3.0F * theme.scale, theme.hairline_px,
                          theme.line);
        if (left + text_size(font, text).x > next_left) continue;
        draw_text(list, font, {left, area.max.y + 5.0F * theme.scale}, theme.dim_text, text);
        next_left = left - 0.25F * text_px;
    }
}

void draw_zero_line(ImDrawList& list, const Theme& theme, const Plot& plot) {
    if (plot.y.low > 0.0 || plot.y.high < 0.0 || plot.y.scale == Scale::logarithmic) return;
    draw_level_line(list, to_pixel(plot.y, 0.0), plot.area.min.x, plot.area.max.x,
                    theme.hairline_px, mixed(theme.line, theme.dim_text, 0.4F));
}

void draw_cursor_line(ImDrawList& list, const Theme& theme, const Plot& plot, double x,
                      ImU32 colour) {
    if (x < plot.x.low || x > plot.x.high) return;
    const float x_px = to_pixel(plot.x, x);
    const float reach = 2.0F * theme.scale;
    // A draw command of its own: where just the line moved, no more than it is painted again.
    list.PushClipRect({x_px - reach, plot.area.min.y}, {x_px + reach, plot.area.max.y}, true);
    draw_upright_line(list, x_px, plot.area.min.y, plot.area.max.y, theme.hairline_px, colour);
    list.PopClipRect();
}

std::vector<Extremes> extremes(std::span<const double> samples, double first, double last,
                               std::size_t columns) {
    if (samples.empty() || columns == 0 || !(first < last)) return {};
    const double last_index = static_cast<double>(samples.size()) - 1.0;
    const double step = (last - first) / static_cast<double>(columns);
    std::vector<Extremes> result(columns);
    for (std::size_t c = 0; c < columns; ++c) {
        const double from = first + static_cast<double>(c) * step;
        const auto begin =
            static_cast<std::size_t>(std::clamp(std::ceil(from) - 1.0, 0.0, last_index));
        const auto end =
            static_cast<std::size_t>(std::clamp(std::ceil(from + step) - 1.0, 0.0, last_index));
        const auto [low, high] = std::minmax_element(
            samples.begin() + static_cast<std::ptrdiff_t>(begin),
            samples.begin() + static_cast<std::ptrdiff_t>(std::max(begin, end)) + 1);
        result[c] = {*low, *high};
    }
    return result;
}

namespace {

// Moved into 0..duration without changing its length.
TimeRange inside(TimeRange range, double duration_s) {
    const double length_s =
        std::clamp(range.length_s(), kShortestRangeS, std::max(duration_s, kShortestRangeS));
    const double last_start_s = std::max(0.0, duration_s - length_s);
    range.start_s = std::clamp(range.start_s, 0.0, last_start_s);
    range.end_s = range.start_s + length_s;
    return range;
}

}  // namespace

TimeRange zoomed(TimeRange range, double factor, double fixed_s, double duration_s) {
    const double length_s = std::clamp(range.length_s() * factor, kShortestRangeS,
                                       std::max(duration_s, kShortestRangeS));
    const double scale = range.length_s() > 0.0 ? length_s / range.length_s() : 1.0;
    range.start_s = fixed_s - (fixed_s - range.start_s) * scale;
    range.end_s = range.start_s + length_s;
    return inside(range, duration_s);
}

TimeRange panned(TimeRange range, double by_s, double duration_s) {
    return inside({range.start_s + by_s, range.end_s + by_s}, duration_s);
}

TimeRange fitted(TimeRange range, double duration_s) {
    if (range.length_s() <= 0.0 || range.end_s > duration_s + 1e-9) return {0.0, duration_s};
    return range;
}

TimeRange unless_whole(TimeRange range, double duration_s) {
    const TimeRange shown = fitted(range, duration_s);
    return shown.length_s() < duration_s - 1e-9 ? shown : TimeRange{};
}

TimeRange followed(TimeRange range, double at_s, double duration_s) {
    if (range.length_s() <= 0.0 || (at_s >= range.start_s && at_s <= range.end_s)) return range;
    return inside({at_s, at_s + range.length_s()}, duration_s);
}

}  // namespace tact
