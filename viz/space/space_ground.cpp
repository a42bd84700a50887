#include <algorithm>
#include <cmath>
#include <numbers>

#include "viz/drawing/colour.h"
#include "viz/drawing/marks.h"
#include "viz/drawing/plot.h"
#include "viz/space/space_parts.h"

namespace tact {

namespace {

// The floor under what the map has on it: its middle and half its sides, in ball radii.
struct Floor {
    Eigen::Vector2d middle = Eigen::Vector2d::Zero();
    Eigen::Vector2d half = Eigen::Vector2d::Constant(1.0);
};

Floor floor_of(const SpaceFit& fit) {
    if (fit.outer.empty()) return {};
    Eigen::Vector2d low = fit.outer.front().head<2>();
    Eigen::Vector2d high = low;
    for (const Eigen::Vector3d& outer : fit.outer) {
        low = low.cwiseMin(outer.head<2>());
        high = high.cwiseMax(outer.head<2>());
    }
    constexpr double kLeastHalf = 0.35;  // a row of points stands on more than a line
    return {(low + high) / 2.0, ((high - low) / 2.0).cwiseMax(kLeastHalf)};
}

// x and y in halves of the floor's sides.
ImVec2 on_floor(const SpaceFit& fit, const SpaceProjection& seen, const Floor& floor, double x,
                double y) {
    const Eigen::Vector2d q = floor.middle + floor.half.cwiseProduct(Eigen::Vector2d{x, y});
    const Eigen::Vector3d p = fit.centre + fit.radius * Eigen::Vector3d{q.x(), q.y(), 0.0};
    const double z = fit.floor - (fit.flat ? 0.0 : kFloorBelow * fit.radius);
    return seen({p.x(), p.y(), z}).at;
}

// How far the floor reaches beyond what is on it: within the pane as long as the map is neither
// zoomed nor moved.
double floor_reach(const SpaceStage& stage, const SpaceCamera& camera, const Floor& floor) {
    constexpr int kAround = 16;
    SpaceCamera whole = camera;
    whole.zoom = 1.0;
    whole.pan_x = whole.pan_y = 0.0;
    const SpaceProjection seen = projection(whole, stage.fit, stage.pane);
    double reach = 1.5;
    for (; reach > 1.0; reach -= 0.05) {
        bool is_inside = true;
        for (int k = 0; k < kAround && is_inside; ++k) {
            const double angle = 2.0 * std::numbers::pi * k / kAround;
            is_inside = stage.pane.contains(
                on_floor(stage.fit, seen, floor, reach * std::cos(angle), reach * std::sin(angle)));
        }
        if (is_inside) break;
    }
    return reach;
}

}  // namespace

// A grid under the map that fades toward its rim.
void draw_floor(const SpaceStage& stage, const SpaceCamera& camera) {
    constexpr int kLines = 5;  // on each side of the middle
    constexpr int kPieces = 20;
    const Floor floor = floor_of(stage.fit);
    const double reach = floor_reach(stage, camera, floor);
    const auto at = [&](double x, double y) {
        return on_floor(stage.fit, stage.seen, floor, x, y);
    };
    const ImU32 colour = mixed(stage.theme.line, stage.theme.dim_text, 0.15F);
    for (int line = -kLines; line <= kLines; ++line) {
        const double across = reach * line / kLines;
        for (int piece = 0; piece < kPieces; ++piece) {
            const double from = reach * (2.0 * piece / kPieces - 1.0);
            const double to = reach * (2.0 * (piece + 1) / kPieces - 1.0);
            const double rim = std::hypot(across, (from + to) / 2.0) / (1.12 * reach);
            if (rim >= 1.0) continue;
            const ImU32 ink = faded(colour, static_cast<float>(1.0 - rim * rim));
            stage.list.AddLine(at(across, from), at(across, to), ink, stage.theme.hairline_px);
            stage.list.AddLine(at(from, across), at(to, across), ink, stage.theme.hairline_px);
        }
    }
}

// From each point down to the floor: what makes height readable.
void draw_drop_lines(const SpaceStage& stage) {
    if (stage.fit.flat || (stage.scene.chosen.empty() && stage.front_to_back.size() > 150)) return;
    const double floor = stage.fit.floor - kFloorBelow * stage.fit.radius;
    for (const std::size_t i : stage.front_to_back) {
        if (is_cloud(stage, i) && stage.scene.selected != i) continue;
        Eigen::Vector3d p = point_of(*stage.scene.points, static_cast<Eigen::Index>(i));
        p.z() = floor;
        const ImVec2 foot = stage.seen(p).at;
        const ImU32 ink = toned(stage, stage.theme.dim_text, 0.12F + 0.25F * nearness(stage, i));
        stage.list.AddLine(stage.discs[i].centre, foot, ink, stage.theme.hairline_px);
        draw_disc(stage.list, stage.theme, foot, 1.6F * stage.theme.scale, ink);
    }
}

namespace {

struct AxesCross {
    ImVec2 origin;
    float room = 0.0F;
    float arm = 0.0F;
    float text_px = 0.0F;
};

AxesCross cross_of(const SpaceStage& stage) {
    const float arm = 22.0F * stage.theme.scale;
    const float text_px = font_or_current(stage.theme.fonts.small).FontSize;
    const float room = arm + 1.3F * text_px;
    return {{stage.pane.min.x + room, stage.pane.max.y - room}, room, arm, text_px};
}

ImVec2 tip_of(const SpaceStage& stage, const SpaceCamera& camera, const AxesCross& cross,
              int axis) {
    const Eigen::Vector3d seen = turned(camera, stage.fit.flat, Eigen::Vector3d::Unit(axis));
    return {cross.arm * static_cast<float>(seen.x()), -cross.arm * static_cast<float>(seen.y())};
}

ImVec2 name_centre(const AxesCross& cross, ImVec2 tip) {
    const float length = std::max(1.0F, std::hypot(tip.x, tip.y));
    return cross.origin + tip * (1.0F + 0.7F * cross.text_px / length);
}

bool is_on(ImVec2 at, ImVec2 centre, float reach) {
    return std::hypot(at.x - centre.x, at.y - centre.y) <= reach;
}

}  // namespace

std::optional<int> axis_at(const SpaceStage& stage, const SpaceCamera& camera, ImVec2 at) {
    if (stage.fit.flat) return std::nullopt;
    const AxesCross cross = cross_of(stage);
    for (int axis = 0; axis < 3; ++axis) {
        const ImVec2 tip = tip_of(stage, camera, cross, axis);
        // One that points at the eye has its name in the middle, as the middle has.
        if (std::hypot(tip.x, tip.y) < 0.4F * cross.arm) continue;
        if (is_on(at, name_centre(cross, tip), 0.75F * cross.text_px)) return axis;
    }
    if (is_on(at, cross.origin, 0.6F * cross.text_px)) return 3;
    return std::nullopt;
}

// The directions of D1-D3 in the lower left corner; returns what it covers.
Rect draw_axes_cross(const SpaceStage& stage, const SpaceCamera& camera) {
    const Theme& theme = stage.theme;
    const AxesCross cross = cross_of(stage);
    const int pointed =
        ImGui::IsItemHovered() ? axis_at(stage, camera, ImGui::GetIO().MousePos).value_or(-1) : -1;
    for (int axis = 0; axis < (stage.fit.flat ? 2 : 3); ++axis) {
        const ImVec2 tip = tip_of(stage, camera, cross, axis);
        const bool lit = pointed == axis;
        stage.list.AddLine(cross.origin, cross.origin + tip,
                           toned(stage, lit ? theme.accent : theme.dim_text, lit ? 1.0F : 0.6F),
                           theme.hairline_px);
        const std::string name = "D" + std::to_string(axis + 1);
        const ImVec2 size = text_size(theme.fonts.small, name);
        draw_text(stage.list, theme.fonts.small, name_centre(cross, tip) - size * 0.5F,
                  toned(stage, lit ? theme.text : theme.dim_text, lit ? 1.0F : 0.75F), name);
    }
    if (!stage.fit.flat) {
        draw_disc(stage.list, theme, cross.origin, (pointed == 3 ? 4.0F : 2.5F) * theme.scale,
                  toned(stage, pointed == 3 ? theme.accent : theme.dim_text, 0.8F));
    }
    return {{cross.origin.x - cross.room, cross.origin.y - cross.room},
            {cross.origin.x + cross.room, cross.origin.y + cross.room}};
}

}  // namespace tact
