#include "viz/charts/profile_view.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "viz/drawing/marks.h"
#include "viz/drawing/plot.h"

namespace tact {

namespace {

// The plot's area below the title, with room for marks at its edges.
Rect curve_area(const Theme& theme, const Rect& area) {
    const float title = text_size(theme.fonts.small, "L").y + 2.0F * theme.scale;
    const float room = theme.mark_px;
    return {{area.min.x + room, area.min.y + title + room}, {area.max.x - room, area.max.y - room}};
}

void draw_title(ImDrawList& list, const Theme& theme, const Rect& area, const ProfileScene& scene) {
    const std::string title = shortened(theme.fonts.small, scene.title, area.width());
    draw_text(list, theme.fonts.small, area.min, theme.text, title);
    const float used = text_size(theme.fonts.small, title).x + theme.gap_px;
    if (used + text_size(theme.fonts.small, scene.detail).x > area.width()) return;
    draw_text(list, theme.fonts.small, {area.min.x + used, area.min.y}, theme.dim_text,
              scene.detail);
}

// The curve has a gap at a value without a best.
void draw_curve(ImDrawList& list, const Theme& theme, const Rect& area, const ProfileScene& scene) {
    std::optional<ImVec2> last;
    for (std::size_t k = 0; k < scene.best.size(); ++k) {
        if (!std::isfinite(scene.best[k])) {
            last.reset();
            continue;
        }
        const ImVec2 at = profile_point(theme, area, scene, k);
        if (last) list.AddLine(*last, at, theme.dim_text, theme.trace_px);
        draw_disc(list, theme, at, 0.35F * theme.mark_px, theme.dim_text);
        last = at;
    }
}

std::optional<std::size_t> nearest(const Theme& theme, const Rect& area, const ProfileScene& scene,
                                   float x) {
    std::optional<std::size_t> found;
    float least = 0.0F;
    for (std::size_t k = 0; k < scene.best.size(); ++k) {
        const float away = std::abs(profile_point(theme, area, scene, k).x - x);
        if (found && away >= least) continue;
        found = k;
        least = away;
    }
    return found;
}

}  // namespace

ImVec2 profile_point(const Theme& theme, const Rect& area, const ProfileScene& scene,
                     std::size_t place) {
    const Rect curve = curve_area(theme, area);
    const double value = std::isfinite(scene.best[place]) ? scene.best[place] : scene.shown.low;
    const Axis y{scene.shown.low, scene.shown.high, Scale::linear, curve.max.y, curve.min.y};
    const float steps = static_cast<float>(std::max<std::size_t>(scene.best.size(), 2) - 1);
    return {curve.min.x + curve.width() * static_cast<float>(place) / steps,
            to_pixel(y, std::clamp(value, scene.shown.low, scene.shown.high))};
}

std::optional<std::size_t> draw_profile(const char* id, const Theme& theme, const Rect& area,
                                        const ProfileScene& scene) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    ImGui::SetCursorScreenPos(area.min);
    ImGui::InvisibleButton(id, {std::max(area.width(), 1.0F), std::max(area.height(), 1.0F)});
    const bool hovered = ImGui::IsItemHovered();
    draw_title(list, theme, area, scene);
    const Rect curve = curve_area(theme, area);
    if (curve.empty() || scene.best.empty()) return std::nullopt;
    draw_level_line(list, area.max.y - theme.hairline_px, area.min.x, area.max.x, theme.hairline_px,
                    theme.line);
    draw_curve(list, theme, area, scene);
    if (scene.before && *scene.before < scene.best.size()) {
        list.AddCircle(profile_point(theme, area, scene, *scene.before), 0.8F * theme.mark_px,
                       theme.dim_text, 0, theme.trace_px);
    }
    if (scene.chosen < scene.best.size()) {
        draw_disc(list, theme, profile_point(theme, area, scene, scene.chosen),
                  0.7F * theme.mark_px, theme.accent);
    }
    if (!hovered) return std::nullopt;
    const auto place = nearest(theme, area, scene, ImGui::GetIO().MousePos.x);
    if (place && scene.readout) {
        const Rect screen{{0.0F, 0.0F}, ImGui::GetIO().DisplaySize};
        draw_readout(*ImGui::GetForegroundDrawList(), theme, screen,
                     profile_point(theme, area, scene, *place), scene.readout(*place));
    }
    return place;
}

namespace {

struct StarFrame {
    ImVec2 middle;
    float radius = 0.0F;  // length of a 1

    ImVec2 at(ImVec2 place) const { return middle + place * radius; }
};

std::vector<ImVec2> placed(const StarFrame& frame, std::span<const double> numbers) {
    std::vector<ImVec2> points = star_outline(numbers);
    for (ImVec2& point : points) point = frame.at(point);
    return points;
}

// Triangles from the centre: a star with one short ray is not convex.
void fill_star(ImDrawList& canvas, const StarFrame& frame, const std::vector<ImVec2>& points,
               ImU32 colour) {
    for (std::size_t k = 0; k < points.size(); ++k) {
        canvas.AddTriangleFilled(frame.middle, points[k], points[(k + 1) % points.size()], colour);
    }
}

}  // namespace

ImVec2 star_ray(std::size_t ray, std::size_t rays) {
    const double turn = rays == 2 ? 0.25 : 1.0 / static_cast<double>(rays);
    const double angle = 2.0 * std::numbers::pi * turn * static_cast<double>(ray);
    return {static_cast<float>(std::sin(angle)), static_cast<float>(-std::cos(angle))};
}

std::vector<ImVec2> star_outline(std::span<const double> numbers) {
    std::vector<ImVec2> points;
    for (std::size_t r = 0; r < numbers.size(); ++r) {
        const auto length = static_cast<float>(std::clamp(numbers[r], 0.0, 1.0));
        points.push_back(star_ray(r, numbers.size()) * length);
    }
    if (numbers.size() < 3) points.push_back({0.0F, 0.0F});
    return points;
}

void draw_star(ImDrawList& canvas, const Theme& theme, const Rect& area,
               std::span<const double> numbers, std::span<const double> compared_with) {
    const StarFrame frame{area.centre(), 0.5F * std::min(area.width(), area.height())};
    for (std::size_t r = 0; r < numbers.size(); ++r) {
        canvas.AddLine(frame.middle, frame.at(star_ray(r, numbers.size())), theme.line,
                       theme.hairline_px);
    }
    const auto own = placed(frame, numbers);
    fill_star(canvas, frame, own, (theme.series & ~IM_COL32_A_MASK) | IM_COL32(0, 0, 0, 90));
    canvas.AddPolyline(own.data(), static_cast<int>(own.size()), theme.series, ImDrawFlags_Closed,
                       1.5F * theme.scale);
    const auto other = placed(frame, compared_with);
    canvas.AddPolyline(other.data(), static_cast<int>(other.size()), theme.dim_text,
                       ImDrawFlags_Closed, 1.0F * theme.scale);
}

}  // namespace tact
