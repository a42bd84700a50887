#include "viz/space_view.h"

#include <imgui_internal.h>

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <numeric>

#include "viz/colour.h"
#include "viz/label_placement.h"
#include "viz/marks.h"
#include "viz/plot.h"
#include "viz/space_stage.h"

namespace tact {
namespace {

constexpr float kClickSlackPx = 4.0F;  // a hand is never quite still

// A grid under the map that fades toward its rim.
void draw_floor(const SpaceStage& stage, const SpaceCamera& camera) {
    constexpr int kLines = 5;  // on each side of the middle
    constexpr int kPieces = 20;
    constexpr double kReach = 1.3;
    const auto at = [&](double x, double y) {
        const Eigen::Vector3d p = stage.fit.centre + stage.fit.radius * Eigen::Vector3d{x, y, 0.0};
        const double z = stage.fit.floor - (stage.fit.flat ? 0.0 : 0.12 * stage.fit.radius);
        return project(camera, stage.fit, stage.pane, {p.x(), p.y(), z}).at;
    };
    const ImU32 colour = mixed(stage.theme.line, stage.theme.dim_text, 0.15F);
    for (int line = -kLines; line <= kLines; ++line) {
        const double across = kReach * line / kLines;
        for (int piece = 0; piece < kPieces; ++piece) {
            const double from = kReach * (2.0 * piece / kPieces - 1.0);
            const double to = kReach * (2.0 * (piece + 1) / kPieces - 1.0);
            const double rim = std::hypot(across, (from + to) / 2.0) / kReach;
            if (rim >= 1.0) continue;
            const ImU32 ink = faded(colour, static_cast<float>(1.0 - rim * rim));
            stage.list.AddLine(at(across, from), at(across, to), ink, stage.theme.hairline_px);
            stage.list.AddLine(at(from, across), at(to, across), ink, stage.theme.hairline_px);
        }
    }
}

// From each point down to the floor: what makes height readable.
void draw_drop_lines(const SpaceStage& stage, const SpaceCamera& camera) {
    if (stage.fit.flat || stage.front_to_back.size() > 150) return;
    const double floor = stage.fit.floor - 0.12 * stage.fit.radius;
    for (const std::size_t i : stage.front_to_back) {
        Eigen::Vector3d p = point_of(*stage.scene.points, static_cast<Eigen::Index>(i));
        p.z() = floor;
        const ImVec2 foot = project(camera, stage.fit, stage.pane, p).at;
        const ImU32 ink = toned(stage, stage.theme.dim_text, 0.12F + 0.25F * nearness(stage, i));
        stage.list.AddLine(stage.discs[i].centre, foot, ink, stage.theme.hairline_px);
        draw_disc(stage.list, stage.theme, foot, 1.6F * stage.theme.scale, ink);
    }
}

// The directions of D1-D3 in the lower left corner; returns what it covers.
Rect draw_axes_cross(const SpaceStage& stage, const SpaceCamera& camera) {
    const Theme& theme = stage.theme;
    const float arm = 22.0F * theme.scale;
    const float text_px = font_or_current(theme.fonts.small).FontSize;
    const float room = arm + 1.3F * text_px;
    const ImVec2 origin{stage.pane.min.x + room, stage.pane.max.y - room};
    for (int axis = 0; axis < (stage.fit.flat ? 2 : 3); ++axis) {
        const Eigen::Vector3d seen = turned(camera, stage.fit.flat, Eigen::Vector3d::Unit(axis));
        const ImVec2 tip{arm * static_cast<float>(seen.x()), -arm * static_cast<float>(seen.y())};
        stage.list.AddLine(origin, origin + tip, toned(stage, theme.dim_text, 0.6F),
                           theme.hairline_px);
        const std::string name = "D" + std::to_string(axis + 1);
        const ImVec2 size = text_size(theme.fonts.small, name);
        const float length = std::max(1.0F, std::hypot(tip.x, tip.y));
        const ImVec2 corner = origin + tip * (1.0F + 0.7F * text_px / length) - size * 0.5F;
        draw_text(stage.list, theme.fonts.small, corner, toned(stage, theme.dim_text, 0.75F), name);
    }
    return {{origin.x - room, origin.y - room}, {origin.x + room, origin.y + room}};
}

void draw_paths(const SpaceStage& stage) {
    for (const auto& path : stage.scene.paths) {
        for (std::size_t k = 1; k < path.size(); ++k) {
            const std::size_t a = path[k - 1];
            const std::size_t b = path[k];
            if (!somewhere(stage, a) || !somewhere(stage, b)) continue;
            const float strength = 0.35F * (presence(stage, a) + presence(stage, b));
            stage.list.AddLine(stage.discs[a].centre, stage.discs[b].centre,
                               toned(stage, stage.theme.dim_text, strength),
                               stage.theme.hairline_px);
        }
    }
}

// Pairs that are too close, thin and in the colour of a warning.
void draw_links(const SpaceStage& stage) {
    for (const SpaceLink& link : stage.scene.links) {
        if (!somewhere(stage, link.a) || !somewhere(stage, link.b)) continue;
        const float strength = std::min(presence(stage, link.a), presence(stage, link.b));
        stage.list.AddLine(stage.discs[link.a].centre, stage.discs[link.b].centre,
                           toned(stage, stage.theme.warning, 0.3F + 0.6F * strength),
                           stage.theme.hairline_px);
    }
}

// The part of a covariance that is seen: J C J', J the change of the place on the screen along each
// axis of the map.
Eigen::Matrix2d seen_covariance(const SpaceStage& stage, const SpaceCamera& camera, std::size_t i) {
    const Eigen::Vector3d p = point_of(*stage.scene.points, static_cast<Eigen::Index>(i));
    const double step = 1e-3 * stage.fit.radius;
    Eigen::Matrix<double, 2, 3> change;
    for (int axis = 0; axis < 3; ++axis) {
        const Eigen::Vector3d moved = p + step * Eigen::Vector3d::Unit(axis);
        const ImVec2 way = project(camera, stage.fit, stage.pane, moved).at - stage.projected[i].at;
        change.col(axis) = Eigen::Vector2d(way.x, way.y) / step;
    }
    return change * stage.scene.spread[i] * change.transpose();
}

// Around where each point might be as well: half of a normal distribution in two dimensions lies
// within sqrt(2 ln 2) standard deviations.
void draw_spread(const SpaceStage& stage, const SpaceCamera& camera) {
    if (stage.scene.spread.size() != stage.discs.size()) return;
    constexpr double kHalf = 1.17741;
    constexpr int kCorners = 32;
    for (const std::size_t i : stage.front_to_back) {
        const Eigen::LLT<Eigen::Matrix2d> root(seen_covariance(stage, camera, i) +
                                               1e-9 * Eigen::Matrix2d::Identity());
        if (root.info() != Eigen::Success) continue;
        const Eigen::Matrix2d half = kHalf * Eigen::Matrix2d(root.matrixL());
        std::array<ImVec2, kCorners> corners;
        for (int k = 0; k < kCorners; ++k) {
            const double angle = 2.0 * std::acos(-1.0) * k / kCorners;
            const Eigen::Vector2d at = half * Eigen::Vector2d(std::cos(angle), std::sin(angle));
            corners[static_cast<std::size_t>(k)] =
                stage.discs[i].centre +
                ImVec2{static_cast<float>(at.x()), static_cast<float>(at.y())};
        }
        const float strength = presence(stage, i);
        const ImU32 colour = stage.scene.looks[i].colour;
        stage.list.AddConvexPolyFilled(corners.data(), kCorners, faded(colour, 0.10F * strength));
        stage.list.AddPolyline(corners.data(), kCorners, faded(colour, 0.5F * strength),
                               ImDrawFlags_Closed, stage.theme.hairline_px);
    }
}

// Where the points were, and the way each has come.
void draw_ghosts(const SpaceStage& stage, const SpaceCamera& camera) {
    if (stage.scene.ghosts == nullptr || stage.scene.ghost_opacity <= 0.0) return;
    const auto opacity = static_cast<float>(std::min(1.0, stage.scene.ghost_opacity));
    const auto rows =
        std::min(static_cast<std::size_t>(stage.scene.ghosts->rows()), stage.scene.labels.size());
    for (std::size_t i = 0; i < rows; ++i) {
        const Eigen::Vector3d p = point_of(*stage.scene.ghosts, static_cast<Eigen::Index>(i));
        if (!p.allFinite() || !somewhere(stage, i)) continue;
        const ImVec2 at = project(camera, stage.fit, stage.pane, p).at;
        const ImU32 ink = faded(stage.scene.looks[i].colour, 0.45F * opacity);
        stage.list.AddLine(at, stage.discs[i].centre, faded(ink, 0.7F), stage.theme.hairline_px);
        stage.list.AddCircle(at, stage.discs[i].radius, ink, 0, stage.theme.hairline_px);
    }
}

bool asked_for(const SpaceStage& stage, std::optional<std::size_t> hovered, std::size_t i) {
    return hovered == i || stage.scene.selected == i;
}

void draw_points(const SpaceStage& stage, std::optional<std::size_t> hovered) {
    const Theme& theme = stage.theme;
    const float edge = 1.5F * theme.scale;
    for (auto it = stage.front_to_back.rbegin(); it != stage.front_to_back.rend(); ++it) {
        const std::size_t i = *it;
        const Disc& d = stage.discs[i];
        const bool marked = asked_for(stage, hovered, i);
        if (marked || stage.chosen[i]) {
            const ImU32 ring = stage.scene.selected == i ? theme.accent : theme.text;
            const float wider = marked ? 4.0F : 3.0F;
            draw_disc(stage.list, theme, d.centre, d.radius + wider * theme.scale,
                      toned(stage, ring, marked ? 1.0F : presence(stage, i)));
            draw_disc(stage.list, theme, d.centre, d.radius + edge, theme.pane);
        } else {
            // A rim of the pane keeps neighbours apart.
            draw_disc(stage.list, theme, d.centre, d.radius + edge * 0.7F, theme.pane);
        }
        PatternLook look = stage.scene.looks[i];
        look.colour = toned(stage, look.colour, marked ? 1.0F : presence(stage, i));
        draw_pattern_mark(stage.list, theme, d.centre, d.radius, look, theme.pane);
    }
}

void draw_pair_line(const SpaceStage& stage, std::size_t a, std::size_t b) {
    const ImVec2 from = stage.discs[a].centre;
    const ImVec2 along = stage.discs[b].centre - from;
    const float length = std::hypot(along.x, along.y);
    const float dash = 5.0F * stage.theme.scale;
    for (float s = 0.0F; s < length; s += 2.0F * dash) {
        stage.list.AddLine(from + along * (s / length),
                           from + along * (std::min(s + dash, length) / length),
                           stage.theme.warning, 1.5F * stage.theme.scale);
    }
}

// At the middle of the line, or above or below it or along it where that would cover a point.
Rect free_plate(const SpaceStage& stage, ImVec2 size, ImVec2 from, ImVec2 to) {
    const float lift = size.y + 8.0F * stage.theme.scale;
    Rect first;
    for (const float along : {0.5F, 0.4F, 0.6F, 0.3F, 0.7F}) {
        for (const float up : {0.0F, lift, -lift}) {
            const ImVec2 middle = from + (to - from) * along - ImVec2{0.0F, up};
            const Rect plate = moved_into(rect_at(middle - size * 0.5F, size), stage.pane);
            if (first.empty()) first = plate;
            const auto covered = [&](const Disc& d) {
                return squared_distance(plate, d.centre) < d.radius * d.radius;
            };
            if (std::none_of(stage.discs.begin(), stage.discs.end(), covered)) return plate;
        }
    }
    return first;
}

// The pair's dissimilarity on a plate, whose place is returned.
Rect draw_pair_value(const SpaceStage& stage, std::size_t a, std::size_t b) {
    if (!stage.scene.dissimilarity) return {};
    const Theme& theme = stage.theme;
    std::string text = grouped(stage.scene.dissimilarity(a, b));
    if (!stage.scene.quantity.empty()) text = std::string{stage.scene.quantity} + " " + text;
    const ImVec2 pad{6.0F * theme.scale, 3.0F * theme.scale};
    const ImVec2 size = text_size(theme.fonts.semibold, text) + pad * 2.0F;
    const Rect plate = free_plate(stage, size, stage.discs[a].centre, stage.discs[b].centre);
    stage.list.AddRectFilled(plate.min, plate.max, theme.hover, theme.rounding_px);
    draw_text(stage.list, theme.fonts.semibold, plate.min + pad, theme.text, text);
    return plate;
}

// The selected and the hovered name are in the larger font.
const ImFont* name_font(const SpaceStage& stage, std::optional<std::size_t> hovered,
                        std::size_t i) {
    const Fonts& fonts = stage.theme.fonts;
    return asked_for(stage, hovered, i) ? fonts.regular : fonts.small;
}

std::vector<LabelRequest> requests(const SpaceStage& stage, std::optional<std::size_t> hovered) {
    std::vector<std::size_t> order;
    for (const auto& first : {stage.scene.selected, hovered, stage.scene.pointed}) {
        if (first && *first < stage.discs.size() && visible(stage, stage.discs[*first]) &&
            std::find(order.begin(), order.end(), *first) == order.end()) {
            order.push_back(*first);
        }
    }
    const std::size_t special = order.size();
    // Chosen ones before others, then from front to back.
    for (const bool chosen : {true, false}) {
        for (const std::size_t i : stage.front_to_back) {
            if (order.size() >= kMostNames) break;
            const auto end = order.begin() + static_cast<std::ptrdiff_t>(special);
            if (stage.chosen[i] == chosen && std::find(order.begin(), end, i) == end) {
                order.push_back(i);
            }
        }
    }
    std::vector<LabelRequest> result;
    const float most_px = stage.pane.width() * 0.4F;
    for (const std::size_t i : order) {
        ImVec2 size = text_size(name_font(stage, hovered, i), stage.scene.labels[i]);
        size.x = std::min(size.x, most_px);
        result.push_back({i, size});
    }
    return result;
}

void draw_names(const SpaceStage& stage, std::span<const Rect> occupied,
                std::optional<std::size_t> hovered) {
    const Theme& theme = stage.theme;
    const auto wanted = requests(stage, hovered);
    // The rings around points count as points.
    std::vector<Disc> discs = stage.discs;
    for (std::size_t i = 0; i < discs.size(); ++i) {
        const bool ringed = stage.chosen[i] || asked_for(stage, hovered, i);
        if (ringed) discs[i].radius += 4.0F * theme.scale;
    }
    const LabelField field{discs, occupied, stage.pane, 3.0F * theme.scale};
    const auto placed = place_labels(wanted, field);
    // No free place, but asked for: on a plate, which keeps others from under it.
    std::vector<Rect> plates(wanted.size());
    for (std::size_t k = 0; k < wanted.size(); ++k) {
        const std::size_t i = wanted[k].disc;
        if (placed[k] || !asked_for(stage, hovered, i)) continue;
        const float pad = 2.0F * theme.scale;
        const float away = discs[i].radius + pad + theme.scale;
        const ImVec2 corner = discs[i].centre + ImVec2{away, -wanted[k].size.y / 2};
        plates[k] = moved_into(inset(rect_at(corner, wanted[k].size), -pad), stage.pane);
    }
    for (std::size_t k = 0; k < wanted.size(); ++k) {
        const std::size_t i = wanted[k].disc;
        const ImFont* font = name_font(stage, hovered, i);
        const bool special = asked_for(stage, hovered, i);
        const std::string name = shortened(font, stage.scene.labels[i], wanted[k].size.x + 0.5F);
        const auto under = [&](const Rect& plate) {
            return !plate.empty() && plate.intersects(*placed[k]);
        };
        if (placed[k] && (special || std::none_of(plates.begin(), plates.end(), under))) {
            const float strength = special ? 1.0F : 0.35F + 0.5F * presence(stage, i);
            draw_text_halo(stage.list, font, placed[k]->min, toned(stage, theme.text, strength),
                           theme.pane, theme.scale, name);
        }
        if (plates[k].empty()) continue;
        stage.list.AddRectFilled(plates[k].min, plates[k].max, theme.hover, theme.rounding_px);
        draw_text(stage.list, font, inset(plates[k], 2.0F * theme.scale).min, theme.text, name);
    }
}

// Turns the mouse into camera moves and clicks. Drags are taken from the frame's own movement, so
// they work whatever moved the mouse.
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
    if (hovered && !camera.orbiting) {
        action.hovered =
            pick(stage.discs, stage.front_to_back, io.MousePos, kClickSlackPx * theme.scale);
    }
    if (ImGui::IsItemActivated()) {
        camera.orbiting = io.MouseDown[ImGuiMouseButton_Left] && !action.hovered;
    }
    const bool dragged = io.MouseDragMaxDistanceSqr[ImGuiMouseButton_Left] >
                         std::pow(kClickSlackPx * theme.scale, 2);
    if (active && camera.orbiting && dragged) {
        stage.fit.flat ? pan(camera, pane, io.MouseDelta)
                       : orbit(camera, io.MouseDelta, theme.scale);
    } else if (active &&
               (io.MouseDown[ImGuiMouseButton_Right] || io.MouseDown[ImGuiMouseButton_Middle])) {
        pan(camera, pane, io.MouseDelta);
    }
    if (hovered && io.MouseWheel != 0.0F) {
        ImGui::SetItemUsingMouseWheel();
        zoom_at(camera, pane, io.MousePos, std::pow(1.15, static_cast<double>(io.MouseWheel)));
    }
    if (ImGui::IsItemDeactivated() && io.MouseReleased[ImGuiMouseButton_Left] && !dragged) {
        if (camera.orbiting) action.clicked_empty = hovered;
        if (!camera.orbiting) action.clicked = action.hovered;
    }
    const bool right_dragged = io.MouseDragMaxDistanceSqr[ImGuiMouseButton_Right] >
                               std::pow(kClickSlackPx * theme.scale, 2);
    if (hovered && io.MouseReleased[ImGuiMouseButton_Right] && !right_dragged) {
        action.right_clicked = action.hovered;
    }
    if (hovered && io.MouseDoubleClicked[ImGuiMouseButton_Left]) {
        action.double_clicked = action.hovered;
        if (!action.hovered) camera = SpaceCamera{.orbiting = camera.orbiting};
    }
    if (!active) camera.orbiting = false;
    if (action.hovered) ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
    if (active && !action.hovered) ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeAll);
    SpaceCamera now = camera;
    now.orbiting = before.orbiting;
    action.camera_changed = now != before;
    return action;
}

// While the mouse is over empty space: what it can do there. Returns what it covers.
Rect draw_hint(const SpaceStage& stage, const SpaceAction& action) {
    if (action.hovered || !ImGui::IsItemHovered() || ImGui::IsItemActive()) return {};
    const Theme& theme = stage.theme;
    const char* text = stage.fit.flat ? "drag to move, wheel to zoom, double click to reset"
                                      : "drag to turn, wheel to zoom, double click to reset";
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
    draw_drop_lines(stage, camera);
    draw_paths(stage);
    draw_spread(stage, camera);
    draw_links(stage);
    draw_ghosts(stage, camera);
    std::array<Rect, 3> occupied{draw_axes_cross(stage, camera), draw_hint(stage, action), Rect{}};
    const bool pair = hovered && scene.selected && *hovered != *scene.selected &&
                      std::max(*hovered, *scene.selected) < scene.labels.size() &&
                      somewhere(stage, *hovered) && somewhere(stage, *scene.selected);
    if (pair) draw_pair_line(stage, *scene.selected, *hovered);
    draw_points(stage, hovered);
    if (pair) occupied[2] = draw_pair_value(stage, *scene.selected, *hovered);
    draw_names(stage, occupied, hovered);
    if (scene.stale) draw_stale(list, theme, pane, ImGui::GetTime());
    list.PopClipRect();
    return action;
}

}  // namespace tact
