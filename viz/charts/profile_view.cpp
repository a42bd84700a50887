#include "viz/charts/profile_view.h"

#include <algorithm>
#include <cmath>

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

}  // namespace tact
