#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "model/text/numbers.h"
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
    const ImU32 colour = stage.theme.line;
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

namespace {

Eigen::Vector3d foot_of(const SpaceStage& stage, std::size_t i) {
    Eigen::Vector3d p = point_of(*stage.scene.points, static_cast<Eigen::Index>(i));
    p.z() = stage.fit.floor - kFloorBelow * stage.fit.radius;
    return p;
}

}  // namespace

// Shadows under the points, on the floor, give them weight and place. Those of a cloud would be one
// blot.
void draw_shadows(const SpaceStage& stage) {
    constexpr std::size_t kMost = 300;
    constexpr int kCorners = 20;
    if (stage.fit.flat || stage.front_to_back.size() > kMost) return;
    const float strength = stage.theme.is_dark ? 0.34F : 0.10F;
    for (const std::size_t i : stage.front_to_back) {
        if (is_cloud(stage, i)) continue;
        const Eigen::Vector3d foot = foot_of(stage, i);
        const double radius = stage.discs[i].radius / stage.seen.px * stage.fit.radius;
        const float whole = strength * (stage.faint[i] ? 0.3F : 1.0F);
        // A soft rim.
        for (const double wider : {1.5, 1.0}) {
            std::array<ImVec2, kCorners> corners;
            for (int k = 0; k < kCorners; ++k) {
                const double angle = 2.0 * std::numbers::pi * k / kCorners;
                const Eigen::Vector3d way{std::cos(angle), std::sin(angle), 0.0};
                corners[static_cast<std::size_t>(k)] = stage.seen(foot + wider * radius * way).at;
            }
            stage.list.AddConvexPolyFilled(corners.data(), kCorners,
                                           faded(IM_COL32_BLACK, 0.6F * whole));
        }
    }
}

// Down to the floor, from the points that are looked at: what makes their height readable.
void draw_drop_lines(const SpaceStage& stage, std::optional<std::size_t> hovered) {
    if (stage.fit.flat) return;
    for (const std::size_t i : stage.front_to_back) {
        const bool looked_at = asked_for(stage, hovered, i) || is_selected(stage, i) ||
                               (stage.chosen[i] && !stage.faint[i]);
        if (!looked_at) continue;
        const ImVec2 foot = stage.seen(foot_of(stage, i)).at;
        const ImU32 ink = toned(stage, stage.theme.dim_text, 0.3F + 0.4F * nearness(stage, i));
        stage.list.AddLine(stage.discs[i].centre, foot, ink, stage.theme.hairline_px);
        draw_disc(stage.list, stage.theme, foot, 1.6F * stage.theme.scale, ink);
    }
}

// A round length of the quantity that the map shows, at the depth of its middle.
Rect draw_scale_bar(const SpaceStage& stage, const Rect& cross) {
    if (!(stage.scene.length_of_one > 0.0)) return {};
    const Theme& theme = stage.theme;
    const double px_of_one = stage.scene.length_of_one / stage.fit.radius * stage.seen.px;
    const double most =
        static_cast<double>(std::min(120.0F * theme.scale, 0.2F * stage.pane.width()));
    if (!(px_of_one > 0.0) || !std::isfinite(px_of_one)) return {};
    const double decade = std::pow(10.0, std::floor(std::log10(most / px_of_one)));
    const double times = most / px_of_one / decade;
    const double length = decade * (times >= 5.0 ? 5.0 : times >= 2.0 ? 2.0 : 1.0);
    const auto px = static_cast<float>(length * px_of_one);
    const std::string words = "about " + std::string(stage.scene.quantity) + " " + grouped(length);
    const ImVec2 size = text_size(theme.fonts.small, words);
    const ImVec2 end{cross.max.x + theme.gap_px, stage.pane.max.y - theme.gap_px};
    const float tick = 4.0F * theme.scale;
    const Rect place{{end.x, end.y - tick - size.y - 2.0F * theme.scale},
                     {end.x + std::max(px, size.x), end.y}};
    if (place.max.x > stage.pane.max.x - 0.3F * stage.pane.width()) return {};
    const ImU32 ink = toned(stage, theme.dim_text, 0.8F);
    draw_level_line(stage.list, end.y, end.x, end.x + px, theme.hairline_px, ink);
    for (const float x : {end.x, end.x + px}) {
        draw_upright_line(stage.list, x, end.y - tick, end.y + 1.0F, theme.hairline_px, ink);
    }
    draw_text(stage.list, theme.fonts.small, place.min, toned(stage, theme.dim_text, 0.9F), words);
    return place;
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
