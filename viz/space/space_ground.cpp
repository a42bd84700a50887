#include <algorithm>
#include <cmath>

#include "viz/drawing/colour.h"
#include "viz/drawing/marks.h"
#include "viz/drawing/plot.h"
#include "viz/space/space_parts.h"

namespace tact {

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
    if (stage.fit.flat || (stage.scene.chosen.empty() && stage.front_to_back.size() > 150)) return;
    const double floor = stage.fit.floor - 0.12 * stage.fit.radius;
    for (const std::size_t i : stage.front_to_back) {
        if (is_cloud(stage, i) && stage.scene.selected != i) continue;
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

}  // namespace tact
