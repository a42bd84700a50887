#include "viz/space/space_gestures.h"

#include <imgui_internal.h>

#include <cmath>

#include "viz/drawing/colour.h"
#include "viz/drawing/marks.h"
#include "viz/space/space_parts.h"

namespace tact {
namespace {

bool is_dragged(ImGuiMouseButton button, const Theme& theme) {
    return ImGui::GetIO().MouseDragMaxDistanceSqr[button] >
           std::pow(kClickSlackPx * theme.scale, 2);
}

SpaceGesture gesture_begun(const SpaceAction& action, bool locked, bool moves) {
    const ImGuiIO& io = ImGui::GetIO();
    if (!io.MouseDown[ImGuiMouseButton_Left]) return SpaceGesture::none;
    if (action.hovered && (io.KeyAlt || (moves && !io.KeyCtrl))) return SpaceGesture::move;
    if (action.hovered) return io.KeyCtrl ? SpaceGesture::between : SpaceGesture::none;
    if (action.proposal) return SpaceGesture::none;
    if (io.KeyShift) return io.KeyCtrl ? SpaceGesture::lasso : SpaceGesture::box;
    return locked ? SpaceGesture::none : SpaceGesture::orbit;
}

// Around the mouse's way: the box between its ends, or the way itself, closed.
bool is_enclosed(const SpaceDrag& drag, ImVec2 at) {
    if (drag.line.size() < 2) return false;
    if (drag.gesture == SpaceGesture::box) {
        const Rect box =
            around({drag.line.front(), drag.line.front()}, {drag.line.back(), drag.line.back()});
        return box.contains(at);
    }
    bool inside = false;
    for (std::size_t k = 0, last = drag.line.size() - 1; k < drag.line.size(); last = k++) {
        const ImVec2 a = drag.line[k];
        const ImVec2 b = drag.line[last];
        const bool crosses = (a.y > at.y) != (b.y > at.y);
        if (crosses && at.x < (b.x - a.x) * (at.y - a.y) / (b.y - a.y) + a.x) inside = !inside;
    }
    return inside;
}

// What lies under the mouse beside the points.
void read_maybes(const SpaceStage& stage, SpaceAction& action) {
    if (action.hovered) return;
    const ImVec2 at = ImGui::GetIO().MousePos;
    const float reach = kClickSlackPx * stage.theme.scale;
    float nearest = reach;
    for (std::size_t k = 0; k < stage.proposals.size(); ++k) {
        const ImVec2 away = stage.proposals[k].centre - at;
        const float gap = std::hypot(away.x, away.y) - stage.proposals[k].radius;
        if (gap > nearest) continue;
        nearest = gap;
        action.proposal = k;
    }
    if (action.proposal) return;
    nearest = 2.0F * reach;
    for (std::size_t k = 0; k < stage.track.size(); ++k) {
        const ImVec2 away = stage.track[k] - at;
        if (std::hypot(away.x, away.y) > nearest) continue;
        nearest = std::hypot(away.x, away.y);
        action.on_track = k;
    }
}

// Where a point that is dragged is now.
void follow_move(const SpaceStage& stage, const SpaceCamera& camera, bool ended,
                 SpaceAction& action) {
    const SpaceDrag& drag = camera.drag;
    if (drag.gesture != SpaceGesture::move || !drag.from) return;
    const Eigen::MatrixXd& points = *stage.scene.points;
    const Eigen::Vector3d to = unprojected(camera, stage.fit, stage.pane,
                                           point_of(points, static_cast<Eigen::Index>(*drag.from)),
                                           ImGui::GetIO().MousePos);
    action.moved = drag.from;
    action.moved_to = Eigen::RowVectorXd(to.head(points.cols()).transpose());
    action.move_ended = ended;
}

void follow_line(SpaceDrag& drag) {
    const ImVec2 at = ImGui::GetIO().MousePos;
    if (drag.line.empty() || !same(drag.line.back(), at)) drag.line.push_back(at);
}

// What the drag that ends here has made.
void end_drag(const SpaceStage& stage, const SpaceCamera& camera, bool hovered, bool dragged,
              SpaceAction& action) {
    const SpaceDrag& drag = camera.drag;
    if (!dragged) {
        action.proposal_clicked = action.proposal;
        if (action.proposal) return;
        if (drag.from || action.hovered) action.clicked = action.hovered;
        action.clicked_empty = hovered && !action.hovered;
        return;
    }
    if (drag.gesture == SpaceGesture::between && drag.from && action.hovered &&
        *action.hovered != *drag.from) {
        action.drawn_between = SpaceLink{*drag.from, *action.hovered};
    }
    if (drag.gesture != SpaceGesture::box && drag.gesture != SpaceGesture::lasso) return;
    action.enclosed.emplace();
    for (std::size_t i = 0; i < stage.discs.size(); ++i) {
        if (somewhere(stage, i) && is_enclosed(drag, stage.discs[i].centre)) {
            action.enclosed->push_back(i);
        }
    }
}

void move_camera(const SpaceStage& stage, const Rect& pane, bool active, bool hovered,
                 SpaceCamera& camera) {
    if (camera.locked) return;
    const ImGuiIO& io = ImGui::GetIO();
    if (active && camera.drag.gesture == SpaceGesture::orbit &&
        is_dragged(ImGuiMouseButton_Left, stage.theme)) {
        stage.fit.flat ? pan(camera, pane, io.MouseDelta)
                       : orbit(camera, io.MouseDelta, stage.theme.scale);
    } else if (active &&
               (io.MouseDown[ImGuiMouseButton_Right] || io.MouseDown[ImGuiMouseButton_Middle])) {
        pan(camera, pane, io.MouseDelta);
    }
    if (hovered && io.MouseWheel != 0.0F) {
        ImGui::SetItemUsingMouseWheel();
        zoom_at(camera, pane, io.MousePos, std::pow(1.15, static_cast<double>(io.MouseWheel)));
    }
}

// Resets, and looks along an axis whose name was pressed.
void read_clicks(const SpaceStage& stage, bool hovered, SpaceAction& action, SpaceCamera& camera) {
    const ImGuiIO& io = ImGui::GetIO();
    if (hovered && io.MouseReleased[ImGuiMouseButton_Right] &&
        !is_dragged(ImGuiMouseButton_Right, stage.theme)) {
        action.right_clicked = action.hovered;
    }
    if (action.clicked_empty && !camera.locked) {
        const auto axis = axis_at(stage, camera, io.MousePos);
        if (axis) look_along(camera, *axis);
        if (axis) action.clicked_empty = false;
    }
    if (!hovered || !io.MouseDoubleClicked[ImGuiMouseButton_Left]) return;
    action.double_clicked = action.hovered;
    const bool on_axis = axis_at(stage, camera, io.MousePos).has_value();
    if (!action.hovered && !on_axis && !camera.locked) camera = SpaceCamera{.drag = camera.drag};
}

}  // namespace

SpaceAction read_mouse(const char* id, const Theme& theme, const Rect& pane, SpaceStage& stage,
                       SpaceCamera& camera) {
    ImGui::SetCursorScreenPos(pane.min);
    ImGui::InvisibleButton(id, pane.size(),
                           ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight |
                               ImGuiButtonFlags_MouseButtonMiddle);
    const bool hovered = ImGui::IsItemHovered();
    const bool active = ImGui::IsItemActive();
    const ImGuiIO& io = ImGui::GetIO();
    const SpaceCamera before = camera;
    SpaceAction action;
    if (hovered && camera.drag.gesture != SpaceGesture::orbit) {
        action.hovered =
            pick(stage.discs, stage.front_to_back, io.MousePos, kClickSlackPx * theme.scale);
    }
    if (hovered && camera.drag.gesture != SpaceGesture::orbit) read_maybes(stage, action);
    if (stage.scene.takes_place) {
        if (active && io.MouseDown[ImGuiMouseButton_Left]) {
            const Eigen::Vector3d to =
                unprojected(camera, stage.fit, pane, stage.fit.centre, io.MousePos);
            action.placed_at = Eigen::RowVectorXd(to.head(stage.scene.points->cols()).transpose());
        }
        move_camera(stage, pane, active, hovered, camera);
        action.camera_changed = camera != before;
        return action;
    }
    if (ImGui::IsItemActivated()) {
        camera.drag = {gesture_begun(action, camera.locked, stage.scene.moves), action.hovered, {}};
    }
    if (active) follow_line(camera.drag);
    action.with_ctrl = io.KeyCtrl;
    if (active && io.MouseDown[ImGuiMouseButton_Left] &&
        camera.drag.gesture == SpaceGesture::none) {
        action.pressed = action.hovered;
        action.proposal_pressed = action.proposal;
    }
    const bool left_dragged = is_dragged(ImGuiMouseButton_Left, theme);
    if (active && left_dragged) follow_move(stage, camera, false, action);
    move_camera(stage, pane, active, hovered, camera);
    if (ImGui::IsItemDeactivated() && io.MouseReleased[ImGuiMouseButton_Left]) {
        end_drag(stage, camera, hovered, left_dragged, action);
        if (left_dragged) follow_move(stage, camera, true, action);
    }
    read_clicks(stage, hovered, action, camera);
    if (!active) camera.drag = {};
    if (action.hovered || action.proposal) ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
    if (active && !action.hovered && !action.proposal)
        ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeAll);
    SpaceCamera now = camera;
    now.drag = before.drag;
    action.camera_changed = now != before;
    return action;
}

void draw_gesture(const SpaceStage& stage, const SpaceCamera& camera,
                  std::optional<std::size_t> hovered) {
    const SpaceDrag& drag = camera.drag;
    const Theme& theme = stage.theme;
    if (drag.line.size() < 2 || !is_dragged(ImGuiMouseButton_Left, theme)) return;
    const float width = 1.5F * theme.scale;
    if (drag.gesture == SpaceGesture::between && drag.from) {
        const ImVec2 from = stage.discs[*drag.from].centre;
        const bool lands = hovered && *hovered != *drag.from;
        const ImVec2 to = lands ? stage.discs[*hovered].centre : drag.line.back();
        stage.list.AddLine(from, to, theme.accent, width);
        for (int k = 1; k < 4 && lands; ++k) {
            draw_disc(stage.list, theme, from + (to - from) * (0.25F * static_cast<float>(k)),
                      3.0F * theme.scale, theme.accent);
        }
    } else if (drag.gesture == SpaceGesture::box) {
        const Rect box =
            around({drag.line.front(), drag.line.front()}, {drag.line.back(), drag.line.back()});
        stage.list.AddRectFilled(box.min, box.max, faded(theme.accent, 0.12F));
        stage.list.AddRect(box.min, box.max, theme.accent, 0.0F, 0, width);
    } else if (drag.gesture == SpaceGesture::lasso) {
        stage.list.AddPolyline(drag.line.data(), static_cast<int>(drag.line.size()), theme.accent,
                               ImDrawFlags_Closed, width);
    }
}

}  // namespace tact
