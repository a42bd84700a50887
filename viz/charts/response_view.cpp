#include "viz/charts/response_view.h"

#include <algorithm>
#include <cmath>

#include "viz/drawing/plot.h"

namespace tact {

namespace {

constexpr float kMarkPx = 3.0F;
constexpr float kKnotReachPx = 12.0F;
constexpr double kRoom = 1.4;  // factor above the largest and below the smallest value

// The range of all drawn points, with some room.
Axis spanned(const ResponseScene& scene, double ResponseMark::*value, double room) {
    Axis axis{INFINITY, 0.0, Scale::logarithmic};
    for (const auto& marks : {scene.table, scene.refused}) {
        for (const ResponseMark& mark : marks) {
            if (!(mark.*value > 0.0)) continue;
            axis.low = std::min(axis.low, mark.*value);
            axis.high = std::max(axis.high, mark.*value);
        }
    }
    if (!(axis.high > 0.0)) return {0.1, 10.0, Scale::logarithmic};
    axis.low /= room;
    axis.high *= room;
    return axis;
}

ImVec2 place_of(const Plot& plot, const ResponseMark& mark) {
    return {to_pixel(plot.x, mark.frequency_hz), to_pixel(plot.y, mark.g)};
}

}  // namespace

ResponseAction draw_response(const char* id, const Theme& theme, const Rect& area,
                             const ResponseScene& scene) {
    ResponseAction action;
    if (area.empty()) return action;
    ImGui::SetCursorScreenPos(area.min);
    ImGui::InvisibleButton(id, area.size());
    const PlotLabels labels{"Hz", "g"};
    const Plot plot = plot_within(area, theme, spanned(scene, &ResponseMark::frequency_hz, 1.1),
                                  spanned(scene, &ResponseMark::g, kRoom), labels);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    draw_axes(list, theme, plot, labels);
    const float radius = kMarkPx * theme.scale;
    for (const ResponseMark& mark : scene.refused) {
        if (!(mark.g > 0.0)) continue;
        list.AddCircle(place_of(plot, mark), radius, theme.warning, 0, theme.trace_px);
    }
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    float nearest = kKnotReachPx * theme.scale;
    for (std::size_t k = 0; k < scene.table.size(); ++k) {
        const ImVec2 at = place_of(plot, scene.table[k]);
        if (k > 0) {
            list.AddLine(place_of(plot, scene.table[k - 1]), at, theme.series, theme.trace_px);
        }
        list.AddCircleFilled(at, radius, theme.series);
        const float away = std::abs(at.x - mouse.x);
        if (!ImGui::IsItemHovered() || away >= nearest) continue;
        nearest = away;
        action.hovered = k;
    }
    if (action.hovered) {
        list.AddCircle(place_of(plot, scene.table[*action.hovered]), 2.0F * radius, theme.text, 0,
                       theme.trace_px);
    }
    return action;
}

}  // namespace tact
