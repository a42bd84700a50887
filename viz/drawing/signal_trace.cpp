// Long signals as lines and bars, for plots of any width.

#include <algorithm>
#include <cmath>
#include <memory>

#include "viz/drawing/body_cache.h"
#include "viz/drawing/colour.h"
#include "viz/drawing/marks.h"
#include "viz/drawing/plot.h"
#include "viz/drawing/wave_body.h"

namespace tact {
namespace {

// One column of a strip at x: soft edge, top, bottom, soft edge.
struct StripColumn {
    float x;
    float top;
    float bottom;
    float tone = 1.0F;  // of the colour's opacity
};

// A band between two lines with edges that fade over one pixel, or do not in vector pictures.
void draw_strip(ImDrawList& list, std::span<const StripColumn> columns, ImU32 colour) {
    if (columns.size() < 2) return;
    const ImVec2 uv = ImGui::GetFontTexUvWhitePixel();
    const ImU32 clear = colour & ~IM_COL32_A_MASK;
    const float soft = (list.Flags & ImDrawListFlags_AntiAliasedFill) != 0 ? 0.5F : 0.0F;
    // Batches keep within the 16-bit indices of one draw command.
    constexpr std::size_t kBatch = 4096;
    for (std::size_t begin = 0; begin + 1 < columns.size(); begin += kBatch) {
        const std::size_t count = std::min(kBatch + 1, columns.size() - begin);
        const int quads = static_cast<int>(count - 1) * 3;
        list.PrimReserve(quads * 6, static_cast<int>(count) * 4);
        const unsigned base = list._VtxCurrentIdx;
        for (const StripColumn& c : columns.subspan(begin, count)) {
            list.PrimWriteVtx({c.x, c.top - soft}, uv, clear);
            const ImU32 ink = c.tone < 1.0F ? faded(colour, c.tone) : colour;
            list.PrimWriteVtx({c.x, c.top + soft}, uv, ink);
            list.PrimWriteVtx({c.x, c.bottom - soft}, uv, ink);
            list.PrimWriteVtx({c.x, c.bottom + soft}, uv, clear);
        }
        for (unsigned i = 0; i + 1 < count; ++i) {
            for (unsigned band = 0; band < 3; ++band) {
                const unsigned a = base + 4 * i + band;
                for (const unsigned v : {a, a + 4, a + 5, a, a + 5, a + 1}) {
                    list.PrimWriteIdx(static_cast<ImDrawIdx>(v));
                }
            }
        }
    }
}

// A quarter of a pixel, in values.
double unseen(const Axis& axis) {
    return 0.25 *
           std::abs((axis.high - axis.low) / static_cast<double>(axis.high_px - axis.low_px));
}

// One column a pixel of what is in view; columns beyond the signal are left out.
struct PixelColumns {
    std::shared_ptr<const WaveBody> body;
    std::size_t begin = 0;
    std::size_t end = 0;

    double from_s(const Axis& time, std::size_t column) const {
        return time.low + static_cast<double>(column) * (time.high - time.low) /
                              static_cast<double>(body->columns.size());
    }
};

PixelColumns pixel_columns(const Theme& theme, const Plot& plot, std::span<const double> samples,
                           double rate_hz, double widest_px) {
    const auto count = static_cast<std::size_t>(std::ceil(plot.area.width()));
    BodyCache none;
    PixelColumns result{kept_body(theme.bodies ? *theme.bodies : none, ImGui::GetFrameCount(),
                                  samples, plot.x.low * rate_hz, plot.x.high * rate_hz, count,
                                  {widest_px, unseen(plot.y)})};
    const double per_column = (plot.x.high - plot.x.low) / static_cast<double>(count);
    const double length_s = static_cast<double>(samples.size()) / rate_hz;
    const auto middles_before = [&](double time_s) {
        const double columns = std::ceil((time_s - plot.x.low) / per_column - 0.5);
        return static_cast<std::size_t>(std::clamp(columns, 0.0, static_cast<double>(count)));
    };
    result.begin = middles_before(0.0);
    result.end = std::max(result.begin, middles_before(length_s));
    return result;
}

double samples_per_pixel(const Plot& plot, double rate_hz) {
    return (plot.x.high - plot.x.low) * rate_hz / static_cast<double>(plot.area.width());
}

void draw_columns(ImDrawList& list, const Theme& theme, const Plot& plot,
                  std::span<const double> samples, double rate_hz, ImU32 colour) {
    constexpr double kWidestPx = 6.0;
    const PixelColumns columns = pixel_columns(theme, plot, samples, rate_hz, kWidestPx);
    const float half_px = theme.trace_px / 2.0F;
    const double half_s = 0.5 * (columns.from_s(plot.x, 1) - plot.x.low);
    const WaveBody& body = *columns.body;
    // A stroke is as wide on a flank as on a crest, where it is wider than a pixel.
    const auto beside = static_cast<std::size_t>(half_px);
    const auto reach = [&](std::size_t c) {
        Extremes e = body.columns[c];
        const std::size_t last = std::min(c + beside + 1, columns.end);
        for (std::size_t k = std::max(columns.begin + beside, c) - beside; k < last; ++k) {
            e.low = std::min(e.low, body.columns[k].low);
            e.high = std::max(e.high, body.columns[k].high);
        }
        return e;
    };
    std::vector<StripColumn> strip;
    strip.reserve(columns.end - columns.begin);
    for (std::size_t c = columns.begin; c < columns.end; ++c) {
        const Extremes e = reach(c);
        strip.push_back({to_pixel(plot.x, columns.from_s(plot.x, c) + half_s),
                         to_pixel(plot.y, e.high) - half_px, to_pixel(plot.y, e.low) + half_px,
                         static_cast<float>(body_tone(body.strength[c]))});
    }
    draw_strip(list, strip, colour);
    const auto is_light = [](const StripColumn& column) { return column.tone < 1.0F; };
    if (std::ranges::none_of(strip, is_light)) return;
    // What is light has an outline: how high it is stays as clear.
    std::vector<StripColumn> upper = strip;
    std::vector<StripColumn> lower = strip;
    for (std::size_t c = 0; c < strip.size(); ++c) {
        upper[c].bottom = std::min(strip[c].bottom, strip[c].top + theme.trace_px);
        lower[c].top = std::max(strip[c].top, strip[c].bottom - theme.trace_px);
        upper[c].tone = lower[c].tone = 1.0F;
    }
    draw_strip(list, upper, colour);
    draw_strip(list, lower, colour);
}

// The edge that faces away from zero, a stroke wide: what the height of a bar is read at.
std::vector<StripColumn> edge_of(std::span<const StripColumn> strip, float zero_px,
                                 float stroke_px) {
    std::vector<StripColumn> edge(strip.begin(), strip.end());
    for (StripColumn& column : edge) {
        if (column.top < zero_px)
            column.bottom = std::min(column.bottom, column.top + stroke_px);
        else
            column.top = std::max(column.top, column.bottom - stroke_px);
    }
    return edge;
}

// Columns that stand for bars narrower than can be told apart: several in a row in which the signal
// is high and low. Of a lone bar no more than its sides are such columns.
std::vector<bool> merged_columns(const WaveBody& body, double least) {
    constexpr std::size_t kInRow = 4;
    const auto is_mixed = [&](const Extremes& e) { return e.high - e.low > least; };
    std::vector<bool> merged(body.columns.size(), false);
    std::size_t run = 0;
    for (std::size_t c = 0; c < merged.size(); ++c) {
        run = is_mixed(body.columns[c]) ? run + 1 : 0;
        if (run < kInRow) continue;
        for (std::size_t k = c + 1 - kInRow; k <= c; ++k) merged[k] = true;
    }
    return merged;
}

// From zero to each value for as long as it lasts: bars, with upright sides on whole pixels. Faint
// below their edge: a signal that stays high is no slab. Bars that merge are fainter still, down to
// what lies between them: a row of pulses looks like no signal that stays, however narrow.
void draw_steps(ImDrawList& list, const Theme& theme, const Plot& plot,
                std::span<const double> samples, double rate_hz, ImU32 colour) {
    constexpr float kGround = 0.4F;
    constexpr float kMerged = 0.4F;                                                // of that
    constexpr float kKept = 1.0F - (1.0F - kGround) / (1.0F - kMerged * kGround);  // makes it whole
    std::vector<StripColumn> strip;
    std::vector<StripColumn> kept;  // of merged bars, what stays between them
    const auto add = [&](double from_s, double to_s, const Extremes& e, bool merged) {
        // Values may grow downwards.
        const auto [top, bottom] = std::minmax(
            {to_pixel(plot.y, std::max(0.0, e.high)), to_pixel(plot.y, std::min(0.0, e.low))});
        const float left = std::round(to_pixel(plot.x, from_s));
        const float right = std::round(to_pixel(plot.x, to_s));
        const float tone = merged ? kMerged : 1.0F;
        const bool goes_on = !strip.empty() && strip.back().top == top &&
                             strip.back().bottom == bottom && strip.back().x == left &&
                             strip.back().tone == tone;
        if (!goes_on) strip.push_back({left, top, bottom, tone});
        if (goes_on && strip.size() > 1) strip.pop_back();
        strip.push_back({right, top, bottom, tone});
        const double stays = std::clamp(0.0, std::min(e.low, e.high), std::max(e.low, e.high));
        const auto [high, low] = std::minmax({to_pixel(plot.y, 0.0), to_pixel(plot.y, stays)});
        const float opaque = merged && stays != 0.0 ? 1.0F : 0.0F;
        kept.push_back({left, high, low, opaque});
        kept.push_back({right, high, low, opaque});
    };
    if (samples_per_pixel(plot, rate_hz) < 1.0) {
        const double last_index = static_cast<double>(samples.size()) - 1.0;
        const double first = std::clamp(std::floor(plot.x.low * rate_hz), 0.0, last_index);
        const double last = std::clamp(std::ceil(plot.x.high * rate_hz), 0.0, last_index);
        for (double i = first; i <= last; i += 1.0) {
            const double value = samples[static_cast<std::size_t>(i)];
            add(i / rate_hz, (i + 1.0) / rate_hz, {value, value}, false);
        }
    } else {
        constexpr double kWidestPx = 3.0;  // a pause of two pixels is seen beside a bar
        const PixelColumns columns = pixel_columns(theme, plot, samples, rate_hz, kWidestPx);
        const std::vector<bool> merged = merged_columns(*columns.body, unseen(plot.y));
        for (std::size_t c = columns.begin; c < columns.end; ++c) {
            add(columns.from_s(plot.x, c), columns.from_s(plot.x, c + 1), columns.body->columns[c],
                merged[c]);
        }
    }
    draw_strip(list, strip, faded(colour, kGround));
    const auto is_kept = [](const StripColumn& column) { return column.tone > 0.0F; };
    if (std::ranges::any_of(kept, is_kept)) {
        draw_strip(list, kept, faded(colour, kKept));
    }
    for (StripColumn& column : strip) column.tone = 1.0F;
    draw_strip(list, edge_of(strip, to_pixel(plot.y, 0.0), theme.trace_px), colour);
}

void draw_polyline(ImDrawList& list, const Theme& theme, const Plot& plot,
                   std::span<const double> samples, double rate_hz, ImU32 colour) {
    const double last_index = static_cast<double>(samples.size()) - 1.0;
    const double first = std::clamp(std::floor(plot.x.low * rate_hz), 0.0, last_index);
    const double last = std::clamp(std::ceil(plot.x.high * rate_hz), 0.0, last_index);
    std::vector<ImVec2> points;
    for (auto i = static_cast<std::size_t>(first); i <= static_cast<std::size_t>(last); ++i) {
        points.push_back(
            {to_pixel(plot.x, static_cast<double>(i) / rate_hz), to_pixel(plot.y, samples[i])});
    }
    draw_path(list, points, colour, theme.trace_px);
}

}  // namespace

void draw_signal(ImDrawList& list, const Theme& theme, const Plot& plot,
                 std::span<const double> samples, double rate_hz, ImU32 colour, TraceStyle style) {
    if (samples.empty() || plot.area.empty() || !(plot.x.low < plot.x.high)) return;
    // Half a stroke above the highest crest is still the crest.
    const float stroke_px = style == TraceStyle::line ? 0.5F * theme.trace_px + 0.5F : 0.0F;
    list.PushClipRect({plot.area.min.x, plot.area.min.y - stroke_px},
                      {plot.area.max.x, plot.area.max.y + stroke_px}, true);
    if (style == TraceStyle::filled) {
        draw_steps(list, theme, plot, samples, rate_hz, colour);
    } else if (samples_per_pixel(plot, rate_hz) < 1.0) {
        draw_polyline(list, theme, plot, samples, rate_hz, colour);
    } else {
        draw_columns(list, theme, plot, samples, rate_hz, colour);
    }
    list.PopClipRect();
}

}  // namespace tact
