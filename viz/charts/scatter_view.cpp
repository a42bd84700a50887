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
constexpr float kPointReachPx = 8.0F;  // of the mouse

bool is_drawn(const ScatterScene& scene, std::size_t k) {
    return std::isfinite(scene.x[k]) && std::isfinite(scene.y[k]);
}

// From the least to the most of the values, with 4 % of air; 0 stays where values begin near it.
Axis axis_of(std::span<const double> values, std::span<const double> more) {
    double low = std::numeric_limits<double>::infinity();
    double high = -low;
    for (const auto& list : {values, more}) {
        for (const double value : list) {
            if (!std::isfinite(value)) continue;
            low = std::min(low, value);
            high = std::max(high, value);
        }
    }
    if (low > high) return {};
    if (low >= 0.0 && low < 0.3 * high) low = 0.0;
    // Values that differ in their last digits alone have no ticks between them.
    const double largest = std::max(std::abs(low), std::abs(high));
    const bool spread = high - low > 1e-6 * largest;
    const double air = spread ? 0.04 * (high - low) : std::max(0.5 * largest, 0.5);
    return {.low = low == 0.0 ? -0.5 * air : low - air, .high = high + air};
}

// The title of x has a line of its own: ticks keep theirs.
Plot plot_of(const Theme& theme, const Rect& area, const ScatterScene& scene) {
    const float text_px = font_or_current(theme.fonts.small).FontSize;
    Rect outer = area;
    outer.max.y -= text_px + 0.25F * theme.gap_px;
    outer.max.x -= kPointPx * theme.scale;
    return plot_within(outer, theme, axis_of(scene.x, {}), axis_of(scene.y, scene.fitted),
                       {.x_unit = " ", .y_unit = scene.y_title});
}

ImVec2 at(const Plot& plot, double x, double y) {
    return {to_pixel(plot.x, x), to_pixel(plot.y, y)};
}

void draw_fit(ImDrawList& list, const Theme& theme, const Plot& plot, const ScatterScene& scene) {
    std::vector<std::size_t> order;
    for (std::size_t k = 0; k < scene.fitted.size(); ++k) {
        if (is_drawn(scene, k) && std::isfinite(scene.fitted[k])) order.push_back(k);
    }
    std::ranges::stable_sort(order, [&scene](std::size_t a, std::size_t b) {
        if (scene.x[a] != scene.x[b]) return scene.x[a] < scene.x[b];
        return scene.fitted[a] < scene.fitted[b];
    });
    std::vector<ImVec2> line;
    for (const std::size_t k : order) {
        const ImVec2 next = at(plot, scene.x[k], scene.fitted[k]);
        if (!line.empty() && line.back().y != next.y) line.push_back({next.x, line.back().y});
        line.push_back(next);
    }
    list.AddPolyline(line.data(), static_cast<int>(line.size()), theme.warning, 0,
                     1.5F * theme.scale);
}

// The nearest point in the mouse's reach.
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
    const ImU32 ink = faded(theme.accent, scene.x.size() > 300 ? 0.5F : 0.8F);
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
    draw_disc(list, theme, centre, kPointPx * theme.scale, theme.accent);
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
    draw_text_halo(list, font, plot.area.max - room - ImVec2{theme.gap_px, theme.gap_px * 0.5F},
                   theme.text, theme.pane, theme.scale, corner);
}

std::size_t stride_of(const ScatterScene& scene) {
    return std::max<std::size_t>(1, (scene.x.size() + kMostScatterPoints - 1) / kMostScatterPoints);
}

}  // namespace

ImVec2 scatter_point(const Theme& theme, const Rect& area, const ScatterScene& scene,
                     std::size_t index) {
    return at(plot_of(theme, area, scene), scene.x[index], scene.y[index]);
}

ScatterAction draw_scatter(const char* id, const Theme& theme, const Rect& area,
                           const ScatterScene& scene) {
    if (area.width() < 1.0F || area.height() < 1.0F) return {};
    const Plot plot = plot_of(theme, area, scene);
    if (plot.area.empty()) return {};
    ImDrawList& list = *ImGui::GetWindowDrawList();
    ImGui::SetCursorScreenPos(area.min);
    const bool pressed = ImGui::InvisibleButton(id, area.size());
    const bool over = ImGui::IsItemHovered();
    const std::size_t stride = stride_of(scene);
    draw_axes(list, theme, plot, {.x_unit = " ", .y_unit = scene.y_title});
    draw_points(list, theme, plot, scene, stride);
    if (!scene.fitted.empty()) draw_fit(list, theme, plot, scene);
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
