#include "viz/charts/scatter_view.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "viz/drawing/colour.h"
#include "viz/drawing/marks.h"
#include "viz/drawing/plot.h"

namespace tact {
namespace {

constexpr float kPointPx = 3.0F;
constexpr float kPointReachPx = 8.0F;  // distance from the mouse

bool is_drawn(const ScatterScene& scene, std::size_t k) {
    return std::isfinite(scene.x[k]) && std::isfinite(scene.y[k]);
}

constexpr std::size_t kFitSlices = 8192;  // finer than pixels

void widen(std::optional<Range>& range, std::span<const double> values) {
    for (const double value : values) {
        if (!std::isfinite(value)) continue;
        if (!range) range = Range{value, value};
        range->low = std::min(range->low, value);
        range->high = std::max(range->high, value);
    }
}

bool is_before(const FitPoint& a, const FitPoint& b) {
    return a.x != b.x ? a.x < b.x : a.fitted < b.fitted;
}

// The least and the last point of each slice of x: the others of a monotone fit lie between them.
// One pass instead of a sort.
std::vector<FitPoint> sliced(std::span<const double> x, std::span<const double> fitted,
                             const Range& range) {
    struct Slice {
        FitPoint first;
        FitPoint last;
        bool any = false;
    };
    std::vector<Slice> slices(kFitSlices);
    const double per_slice = range.high > range.low ? range.high - range.low : 1.0;
    for (std::size_t k = 0; k < fitted.size(); ++k) {
        const FitPoint point{x[k], fitted[k]};
        if (!std::isfinite(point.x) || !std::isfinite(point.fitted)) continue;
        const double share = (point.x - range.low) / per_slice;
        Slice& slice = slices[static_cast<std::size_t>(share * (kFitSlices - 1))];
        if (!slice.any || is_before(point, slice.first)) slice.first = point;
        if (!slice.any || is_before(slice.last, point)) slice.last = point;
        slice.any = true;
    }
    std::vector<FitPoint> fit;
    for (const Slice& slice : slices) {
        if (slice.any) fit.push_back(slice.first);
        if (slice.any && slice.last != slice.first) fit.push_back(slice.last);
    }
    return fit;
}

// The range of the values with 4 % of room; starts at 0 if they begin near it.
Axis axis_of(const std::optional<Range>& range) {
    if (!range) return {};
    double low = range->low;
    const double high = range->high;
    if (low >= 0.0 && low < 0.3 * high) low = 0.0;
    // Values that differ only in their last digits have no ticks between them.
    const double largest = std::max(std::abs(low), std::abs(high));
    const bool spread = high - low > 1e-6 * largest;
    const double air = spread ? 0.04 * (high - low) : std::max(0.5 * largest, 0.5);
    return {.low = low == 0.0 ? -0.5 * air : low - air, .high = high + air};
}

ScatterSummary known_summary(const ScatterScene& scene) {
    return scene.summary != nullptr ? *scene.summary : summary_of(scene.x, scene.y, scene.fitted);
}

// The title of x has a separate line: ticks keep theirs.
Plot plot_of(const Theme& theme, const Rect& area, const ScatterScene& scene,
             const ScatterSummary& summary) {
    const float text_px = font_or_current(theme.fonts.small).FontSize;
    Rect outer = area;
    outer.max.y -= text_px + 0.25F * theme.gap_px;
    outer.max.x -= kPointPx * theme.scale;
    return plot_within(outer, theme, axis_of(summary.x), axis_of(summary.y),
                       {.x_unit = " ", .y_unit = scene.y_title});
}

ImVec2 at(const Plot& plot, double x, double y) {
    return {to_pixel(plot.x, x), to_pixel(plot.y, y)};
}

// The first and the last point in each pixel column, and the step between neighbours.
std::vector<ImVec2> fit_line(const Plot& plot, std::span<const FitPoint> fit) {
    std::vector<ImVec2> line;
    const auto step_to = [&line](ImVec2 next) {
        if (!line.empty() && line.back().y != next.y) line.push_back({next.x, line.back().y});
        line.push_back(next);
    };
    const auto pixel_of = [&](std::size_t k) { return at(plot, fit[k].x, fit[k].fitted); };
    for (std::size_t k = 0; k < fit.size();) {
        const ImVec2 first = pixel_of(k);
        const float end_px = std::floor(first.x) + 1.0F;
        std::size_t last = k;
        while (last + 1 < fit.size() && to_pixel(plot.x, fit[last + 1].x) < end_px) ++last;
        step_to(first);
        if (last > k) step_to(pixel_of(last));
        k = last + 1;
    }
    return line;
}

// Each step is a bar on whole pixels: the joints of a polyline are wedges if steps are narrow.
void draw_fit(ImDrawList& list, std::span<const ImVec2> corners, ImU32 colour, float width_px) {
    const float width = whole_px(width_px);
    const auto on_pixels = [width](ImVec2 corner) {
        return ImVec2{std::round(corner.x - 0.5F * width), std::round(corner.y - 0.5F * width)};
    };
    for (std::size_t k = 0; k + 1 < corners.size(); ++k) {
        const ImVec2 a = on_pixels(corners[k]);
        const ImVec2 b = on_pixels(corners[k + 1]);
        if (a.x == b.x && a.y == b.y && k > 0) continue;
        list.AddRectFilled({std::min(a.x, b.x), std::min(a.y, b.y)},
                           {std::max(a.x, b.x) + width, std::max(a.y, b.y) + width}, colour);
    }
}

// The nearest point within reach of the mouse.
std::optional<std::size_t> nearest(const Theme& theme, const Plot& plot, const ScatterScene& scene,
                                   std::size_t stride) {
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    std::optional<std::size_t> found;
    float least = std::pow(kPointReachPx * theme.scale, 2.0F);
    for (std::size_t k = 0; k < scene.x.size(); k += stride) {
        if (!is_drawn(scene, k)) continue;
        const ImVec2 away = at(plot, scene.x[k], scene.y[k]) - mouse;
        const float squared = away.x * away.x + away.y * away.y;
        if (squared > least) continue;
        least = squared;
        found = k;
    }
    return found;
}

void draw_points(ImDrawList& list, const Theme& theme, const Plot& plot, const ScatterScene& scene,
                 std::size_t stride) {
    const ImU32 ink = faded(theme.series, scene.x.size() > 300 ? 0.5F : 0.8F);
    for (std::size_t k = 0; k < scene.x.size(); k += stride) {
        if (!is_drawn(scene, k)) continue;
        draw_disc(list, theme, at(plot, scene.x[k], scene.y[k]), kPointPx * theme.scale, ink);
    }
}

void draw_marked(ImDrawList& list, const Theme& theme, const Plot& plot, const ScatterScene& scene,
                 std::optional<std::size_t> which) {
    if (!which || *which >= scene.x.size() || !is_drawn(scene, *which)) return;
    const ImVec2 centre = at(plot, scene.x[*which], scene.y[*which]);
    draw_disc(list, theme, centre, 2.0F * kPointPx * theme.scale, theme.text);
    draw_disc(list, theme, centre, 1.4F * kPointPx * theme.scale, theme.pane);
    draw_disc(list, theme, centre, kPointPx * theme.scale, theme.series);
}

void draw_titles(ImDrawList& list, const Theme& theme, const Rect& area, const Plot& plot,
                 const ScatterScene& scene, std::size_t stride) {
    const ImFont* font = theme.fonts.small;
    const ImVec2 size = text_size(font, scene.x_title);
    const float below = area.max.y - size.y;
    draw_text(list, font, {std::max(area.min.x, plot.area.max.x - size.x), below}, theme.dim_text,
              scene.x_title);
    std::string corner{scene.corner};
    if (stride > 1) corner += (corner.empty() ? "" : ", ") + std::string("not all pairs drawn");
    const ImVec2 room = text_size(font, corner);
    // Above the lowest grid line if that is near the bottom: text on a line is hard to read.
    float foot = plot.area.max.y;
    const std::vector<double> ticks = round_ticks(plot.y.low, plot.y.high);
    const float line = ticks.empty() ? foot : to_pixel(plot.y, ticks.front());
    if (foot - line < room.y + theme.gap_px) foot = line;
    draw_text_halo(list, font,
                   {plot.area.max.x - room.x - theme.gap_px, foot - room.y - 0.5F * theme.gap_px},
                   theme.text, theme.pane, theme.scale, corner);
}

std::size_t stride_of(const ScatterScene& scene) {
    return std::max<std::size_t>(1, (scene.x.size() + kMostScatterPoints - 1) / kMostScatterPoints);
}

}  // namespace

ScatterSummary summary_of(std::span<const double> x, std::span<const double> y,
                          std::span<const double> fitted) {
    ScatterSummary summary;
    widen(summary.x, x);
    widen(summary.y, y);
    widen(summary.y, fitted);
    if (summary.x) summary.fit = sliced(x, fitted, *summary.x);
    return summary;
}

std::vector<ImVec2> scatter_fit_line(const Theme& theme, const Rect& area,
                                     const ScatterScene& scene) {
    const ScatterSummary summary = known_summary(scene);
    return fit_line(plot_of(theme, area, scene, summary), summary.fit);
}

ImVec2 scatter_point(const Theme& theme, const Rect& area, const ScatterScene& scene,
                     std::size_t index) {
    // Many points are queried for one scene, so its summary is not copied for each.
    const ScatterSummary own =
        scene.summary == nullptr ? summary_of(scene.x, scene.y, scene.fitted) : ScatterSummary{};
    const ScatterSummary& summary = scene.summary != nullptr ? *scene.summary : own;
    return at(plot_of(theme, area, scene, summary), scene.x[index], scene.y[index]);
}

ScatterAction draw_scatter(const char* id, const Theme& theme, const Rect& area,
                           const ScatterScene& scene) {
    if (area.width() < 1.0F || area.height() < 1.0F) return {};
    const ScatterSummary own =
        scene.summary == nullptr ? summary_of(scene.x, scene.y, scene.fitted) : ScatterSummary{};
    const ScatterSummary& summary = scene.summary != nullptr ? *scene.summary : own;
    const Plot plot = plot_of(theme, area, scene, summary);
    if (plot.area.empty()) return {};
    ImDrawList& list = *ImGui::GetWindowDrawList();
    ImGui::SetCursorScreenPos(area.min);
    const bool pressed = ImGui::InvisibleButton(id, area.size());
    const bool over = ImGui::IsItemHovered();
    const std::size_t stride = stride_of(scene);
    draw_axes(list, theme, plot, {.x_unit = " ", .y_unit = scene.y_title});
    draw_fit(list, fit_line(plot, summary.fit), theme.text, 1.5F * theme.scale);
    draw_points(list, theme, plot, scene, stride);
    draw_titles(list, theme, area, plot, scene, stride);
    ScatterAction action;
    if (over) action.hovered = nearest(theme, plot, scene, stride);
    if (pressed) action.clicked = action.hovered;
    draw_marked(list, theme, plot, scene, scene.selected);
    draw_marked(list, theme, plot, scene, action.hovered);
    if (scene.stale) draw_stale(list, theme, plot.area, ImGui::GetTime());
    if (action.hovered) {
        ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
        if (scene.readout) {
            draw_readout(list, theme, area, ImGui::GetIO().MousePos,
                         scene.readout(*action.hovered));
        }
    }
    return action;
}

}  // namespace tact
