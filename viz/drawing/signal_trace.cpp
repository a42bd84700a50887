// Long signals as lines and bars, for plots of any width.

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <optional>
#include <vector>

#include "viz/drawing/body_cache.h"
#include "viz/drawing/colour.h"
#include "viz/drawing/marks.h"
#include "viz/drawing/plot.h"
#include "viz/drawing/wave_body.h"

namespace tact {
namespace {

// Where a band is crossed from one side to the other: soft edge, ink, ink, soft edge.
struct Crossing {
    std::array<ImVec2, 4> at;
    ImU32 ink;
};

// How far an edge fades; in vector pictures it does not.
float softness(const ImDrawList& list) {
    return (list.Flags & ImDrawListFlags_AntiAliasedFill) != 0 ? 0.5F : 0.0F;
}

void draw_band(ImDrawList& list, std::span<const Crossing> crossings) {
    if (crossings.size() < 2) return;
    const ImVec2 uv = ImGui::GetFontTexUvWhitePixel();
    // Batches keep within the 16-bit indices of one draw command.
    constexpr std::size_t kBatch = 4096;
    for (std::size_t begin = 0; begin + 1 < crossings.size(); begin += kBatch) {
        const std::size_t count = std::min(kBatch + 1, crossings.size() - begin);
        const int quads = static_cast<int>(count - 1) * 3;
        list.PrimReserve(quads * 6, static_cast<int>(count) * 4);
        const unsigned base = list._VtxCurrentIdx;
        for (const Crossing& c : crossings.subspan(begin, count)) {
            const ImU32 clear = c.ink & ~IM_COL32_A_MASK;
            list.PrimWriteVtx(c.at[0], uv, clear);
            list.PrimWriteVtx(c.at[1], uv, c.ink);
            list.PrimWriteVtx(c.at[2], uv, c.ink);
            list.PrimWriteVtx(c.at[3], uv, clear);
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

// One column of a strip at x.
struct StripColumn {
    float x;
    float top;
    float bottom;
    float tone = 1.0F;  // of the colour's opacity
};

// What is between two lines.
void draw_strip(ImDrawList& list, std::span<const StripColumn> columns, ImU32 colour) {
    const float soft = softness(list);
    std::vector<Crossing> crossings;
    crossings.reserve(columns.size());
    for (const StripColumn& c : columns) {
        crossings.push_back({{ImVec2{c.x, c.top - soft},
                              {c.x, c.top + soft},
                              {c.x, c.bottom - soft},
                              {c.x, c.bottom + soft}},
                             c.tone < 1.0F ? faded(colour, c.tone) : colour});
    }
    draw_band(list, crossings);
}

// A line through points. Its sharp turns are cut off: mitred, as ImGui has them, each crest would
// end in a needle that is no part of the signal.
void draw_stroke(ImDrawList& list, std::span<const ImVec2> points, ImU32 colour, float width_px) {
    if (points.size() < 2) return;
    const float soft = softness(list);
    const float reach = 0.5F * width_px + soft;
    const float ink = std::max(0.0F, 0.5F * width_px - soft);
    std::vector<Crossing> crossings;
    crossings.reserve(points.size());
    const auto add = [&](ImVec2 at, ImVec2 normal) {
        crossings.push_back(
            {{at - normal * reach, at - normal * ink, at + normal * ink, at + normal * reach},
             colour});
    };
    const auto normal_after = [&](std::size_t k) {
        const ImVec2 way = points[k + 1] - points[k];
        const float length = std::hypot(way.x, way.y);
        return length > 0.0F ? ImVec2{way.y / length, -way.x / length} : ImVec2{};
    };
    ImVec2 before = normal_after(0);
    add(points.front(), before);
    for (std::size_t k = 1; k + 1 < points.size(); ++k) {
        constexpr float kSharp = 0.5F;
        const ImVec2 after = normal_after(k);
        const ImVec2 sum = before + after;
        const float squared = sum.x * sum.x + sum.y * sum.y;
        if (squared > 4.0F * kSharp) {
            add(points[k], sum * (2.0F / squared));
        } else {
            add(points[k], before);
            add(points[k], after);
        }
        before = after;
    }
    add(points.back(), before);
    draw_band(list, crossings);
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

// The columns [begin, end) of a wave whose periods can be seen: through the least and the most of
// each in the order of their samples, at their own times.
void draw_seen(ImDrawList& list, const Theme& theme, const Plot& plot,
               std::span<const double> samples, double rate_hz, const PixelColumns& columns,
               std::size_t begin, std::size_t end, ImU32 colour) {
    const double last_index = static_cast<double>(samples.size()) - 1.0;
    const auto sample_before = [&](std::size_t column) {
        const double at = std::ceil(columns.from_s(plot.x, column) * rate_hz) - 1.0;
        return static_cast<std::size_t>(std::clamp(at, 0.0, last_index));
    };
    std::vector<ImVec2> points;
    std::optional<std::size_t> drawn;
    const auto add = [&](std::size_t i, double value) {
        if (drawn && i <= *drawn) return;
        drawn = i;
        points.push_back(
            {to_pixel(plot.x, static_cast<double>(i) / rate_hz), to_pixel(plot.y, value)});
    };
    for (std::size_t c = begin; c < end; ++c) {
        const std::size_t first = sample_before(c);
        const std::size_t last = sample_before(c + 1);
        const auto [low, high] =
            std::ranges::minmax_element(samples.subspan(first, last - first + 1));
        const auto least = static_cast<std::size_t>(low - samples.begin());
        const auto most = static_cast<std::size_t>(high - samples.begin());
        const Extremes& e = columns.body->columns[c];  // with the crests between samples
        if (c == begin) add(first, samples[first]);
        if (least < most) {
            add(least, e.low);
            add(most, e.high);
        } else {
            add(most, e.high);
            add(least, e.low);
        }
        if (c + 1 == end) add(last, samples[last]);
    }
    draw_stroke(list, points, colour, theme.trace_px);
}

// The columns [begin, end) of a wave whose periods cannot.
void draw_filled(ImDrawList& list, const Theme& theme, const Plot& plot,
                 const PixelColumns& columns, std::size_t begin, std::size_t end, ImU32 colour) {
    const float half_px = theme.trace_px / 2.0F;
    const double half_s = 0.5 * (columns.from_s(plot.x, 1) - plot.x.low);
    std::vector<StripColumn> strip;
    strip.reserve(end - begin);
    for (std::size_t c = begin; c < end; ++c) {
        const Extremes& e = columns.body->columns[c];
        strip.push_back({to_pixel(plot.x, columns.from_s(plot.x, c) + half_s),
                         to_pixel(plot.y, e.high) - half_px, to_pixel(plot.y, e.low) + half_px,
                         static_cast<float>(body_tone(columns.body->strength[c]))});
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

void draw_columns(ImDrawList& list, const Theme& theme, const Plot& plot,
                  std::span<const double> samples, double rate_hz, ImU32 colour) {
    const double widest_px = 4.0 * std::max(1.0, double{theme.trace_px});
    const PixelColumns columns = pixel_columns(theme, plot, samples, rate_hz, widest_px);
    const std::vector<bool>& filled = columns.body->filled;
    for (std::size_t begin = columns.begin; begin < columns.end;) {
        std::size_t end = begin + 1;
        while (end < columns.end && filled[end] == filled[begin]) ++end;
        if (filled[begin]) {
            draw_filled(list, theme, plot, columns, begin, end, colour);
        } else {
            // Into the columns beside them, whose strips end in their middles.
            draw_seen(list, theme, plot, samples, rate_hz, columns,
                      std::max(begin, columns.begin + 1) - 1, std::min(end + 1, columns.end),
                      colour);
        }
        begin = end;
    }
}

// The edge that faces away from zero, a stroke wide: what the height of a bar is read at. The
// narrow steps of a flank have none: each is but on the way.
std::vector<StripColumn> edge_of(std::span<const StripColumn> strip, float zero_px,
                                 float stroke_px) {
    std::vector<StripColumn> edge(strip.begin(), strip.end());
    for (StripColumn& column : edge) {
        if (column.top < zero_px)
            column.bottom = std::min(column.bottom, column.top + stroke_px);
        else
            column.top = std::max(column.top, column.bottom - stroke_px);
    }
    // Every bar is two columns.
    const std::vector<StripColumn> all = edge;
    for (std::size_t k = 2; k + 3 < all.size(); k += 2) {
        const StripColumn& before = all[k - 1];
        const StripColumn& after = all[k + 2];
        const bool is_narrow = all[k + 1].x - all[k].x <= 2.0F * stroke_px;
        const bool is_between = before.x == all[k].x && after.x == all[k + 1].x;
        const float rise = all[k].top - before.top;
        const float next = after.top - all[k].top;
        if (is_narrow && is_between && rise * next > 0.0F && std::abs(rise) > stroke_px &&
            std::abs(next) > stroke_px) {
            edge[k].tone = edge[k + 1].tone = 0.0F;
        }
    }
    return edge;
}

// Columns that stand for bars narrower than can be told apart: several in a row in which the signal
// is high and low. Only the sides of a lone bar are such columns.
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
    draw_stroke(list, points, colour, theme.trace_px);
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
