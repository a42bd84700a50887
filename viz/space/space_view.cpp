#include "viz/space/space_view.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

#include "viz/drawing/marks.h"
#include "viz/drawing/plot.h"
#include "viz/space/space_gestures.h"
#include "viz/space/space_parts.h"

namespace tact {
namespace {

// What the mouse can do where it is. Returns what that covers.
Rect draw_hint(const SpaceStage& stage, const SpaceAction& action) {
    if (!ImGui::IsItemHovered() || ImGui::IsItemActive()) return {};
    const Theme& theme = stage.theme;
    const std::string_view text = stage.scene.takes_place ? "click where it belongs, wheel to zoom"
                                  : action.hovered        ? stage.scene.point_hint
                                  : stage.fit.flat
                                      ? "drag to move, Shift+drag to select, wheel to zoom"
                                      : "drag to turn, Shift+drag to select, wheel to zoom";
    if (text.empty()) return {};
    const ImVec2 size = text_size(theme.fonts.small, text);
    const float left = stage.pane.max.x - size.x - theme.gap_px;
    if (left < stage.pane.min.x + stage.pane.width() * 0.3F) return {};
    const Rect place = rect_at({left, stage.pane.max.y - size.y - theme.gap_px}, size);
    draw_text(stage.list, theme.fonts.small, place.min, toned(stage, theme.dim_text, 0.8F), text);
    return place;
}

}  // namespace

SpaceAction draw_space(const char* id, const Theme& theme, const Rect& pane,
                       const SpaceScene& scene, SpaceCamera& camera) {
    assert(scene.points != nullptr && "a space has points");
    assert(scene.labels.size() == static_cast<std::size_t>(scene.points->rows()) &&
           scene.looks.size() == scene.labels.size() && "one name and one look for each point");
    if (pane.width() < 1.0F || pane.height() < 1.0F) return {};
    ImDrawList& list = *ImGui::GetWindowDrawList();
    SpaceStage stage = staged(list, theme, pane, scene);
    place_points(stage, camera);
    const SpaceAction action = read_mouse(id, theme, pane, stage, camera);
    if (action.camera_changed) place_points(stage, camera);
    const std::optional<std::size_t> hovered = action.hovered ? action.hovered : scene.pointed;

    list.PushClipRect(pane.min, pane.max, true);
    draw_floor(stage, camera);
    draw_shadows(stage);
    draw_drop_lines(stage, hovered);
    draw_paths(stage);
    draw_cloud(stage);
    draw_spread(stage);
    draw_links(stage);
    draw_ghosts(stage);
    const Rect cross = draw_axes_cross(stage, camera);
    std::array<Rect, 4> occupied{cross, draw_hint(stage, action), draw_scale_bar(stage, cross),
                                 Rect{}};
    const bool pair = hovered && scene.selected && *hovered != *scene.selected &&
                      std::max(*hovered, *scene.selected) < scene.labels.size() &&
                      somewhere(stage, *hovered) && somewhere(stage, *scene.selected);
    if (pair) draw_pair_line(stage, *scene.selected, *hovered);
    draw_track(stage, action.on_track);
    draw_points(stage, hovered);
    draw_proposals(stage, action.proposal);
    draw_wanted(stage);
    if (pair) occupied[3] = draw_pair_value(stage, *scene.selected, *hovered);
    draw_names(stage, occupied, hovered);
    draw_gesture(stage, camera, hovered);
    if (scene.stale) draw_stale(list, theme, pane, ImGui::GetTime());
    list.PopClipRect();
    return action;
}

}  // namespace tact
