#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>
#include <vector>

#include "viz/drawing/colour.h"
#include "viz/drawing/marks.h"
#include "viz/space/space_parts.h"

namespace tact {

namespace {

constexpr double kLeastContrast = 3.0;  // of graphics, WCAG 2.1

// The moves as they are seen: J is the change of the place on the screen along each axis of the
// map.
Eigen::Matrix2Xd seen_moves(const SpaceStage& stage, std::size_t i) {
    const Eigen::Vector3d p = point_of(*stage.scene.points, static_cast<Eigen::Index>(i));
    const double step = 1e-3 * stage.fit.radius;
    Eigen::Matrix<double, 2, 3> change;
    for (int axis = 0; axis < 3; ++axis) {
        const Eigen::Vector3d moved = p + step * Eigen::Vector3d::Unit(axis);
        const ImVec2 way = stage.seen(moved).at - stage.projected[i].at;
        change.col(axis) = Eigen::Vector2d(way.x, way.y) / step;
    }
    return change * stage.scene.spread[i];
}

// A head at the rim of a disc that an arrow of this length ends at; too short a way has none.
void draw_arrow_head(const SpaceStage& stage, ImVec2 from, const Disc& to, ImU32 ink) {
    const ImVec2 way = to.centre - from;
    const float length = std::hypot(way.x, way.y);
    const float head = 7.0F * stage.theme.scale;
    if (length < to.radius + head) return;
    const ImVec2 along{way.x / length, way.y / length};
    const ImVec2 aside{-0.4F * head * along.y, 0.4F * head * along.x};
    const ImVec2 tip = to.centre - along * (to.radius + 2.0F * stage.theme.scale);
    const ImVec2 foot = tip - along * head;
    stage.list.AddTriangleFilled(tip, foot + aside, foot - aside, ink);
}

}  // namespace

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
    const std::size_t count = stage.scene.links.size();
    const std::size_t shown = std::min(count, kMostLinks);
    for (std::size_t k = 0; k < shown; ++k) {
        const SpaceLink& link = stage.scene.links[k * count / shown];
        if (!somewhere(stage, link.a) || !somewhere(stage, link.b)) continue;
        const float strength = std::min(presence(stage, link.a), presence(stage, link.b));
        stage.list.AddLine(stage.discs[link.a].centre, stage.discs[link.b].centre,
                           toned(stage, stage.theme.warning, 0.3F + 0.6F * strength),
                           stage.theme.hairline_px);
    }
}

std::optional<Eigen::Matrix2d> half_ellipse(const Eigen::Matrix2Xd& moves) {
    if (moves.cols() == 0) return std::nullopt;
    constexpr double kLeast = 1e-9;  // of a point that stays where it is, or moves along a line
    const Eigen::Matrix2d second = moves * moves.transpose() / static_cast<double>(moves.cols());
    // Its Cholesky root.
    const double x = std::sqrt(second(0, 0) + kLeast);
    const double y = second(1, 0) / x;
    const double rest = second(1, 1) + kLeast - y * y;
    if (!(rest > 0.0)) return std::nullopt;
    const Eigen::Matrix2d root{{x, 0.0}, {y, std::sqrt(rest)}};
    const Eigen::Matrix2Xd white = root.triangularView<Eigen::Lower>().solve(moves);
    std::vector<double> reach(static_cast<std::size_t>(moves.cols()));
    for (std::size_t k = 0; k < reach.size(); ++k) {
        reach[k] = white.col(static_cast<Eigen::Index>(k)).norm();
    }
    const auto middle = reach.begin() + static_cast<std::ptrdiff_t>((reach.size() - 1) / 2);
    std::ranges::nth_element(reach, middle);
    return *middle * root;
}

// Around where half of the draws put each point, as seen from here.
void draw_spread(const SpaceStage& stage) {
    if (stage.scene.spread.size() != stage.discs.size()) return;
    constexpr int kCorners = 32;
    const std::size_t shown = std::min(stage.front_to_back.size(), kMostSpreads);
    for (const std::size_t i : std::span(stage.front_to_back).first(shown)) {
        const std::optional<Eigen::Matrix2d> half = half_ellipse(seen_moves(stage, i));
        if (!half) continue;
        std::array<ImVec2, kCorners> corners;
        for (int k = 0; k < kCorners; ++k) {
            const double angle = 2.0 * std::acos(-1.0) * k / kCorners;
            const Eigen::Vector2d at = *half * Eigen::Vector2d(std::cos(angle), std::sin(angle));
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
void draw_ghosts(const SpaceStage& stage) {
    if (stage.scene.ghosts == nullptr || stage.scene.ghost_opacity <= 0.0) return;
    const auto opacity = static_cast<float>(std::min(1.0, stage.scene.ghost_opacity));
    const auto rows =
        std::min(static_cast<std::size_t>(stage.scene.ghosts->rows()), stage.scene.labels.size());
    for (std::size_t i = 0; i < rows; ++i) {
        const Eigen::Vector3d p = point_of(*stage.scene.ghosts, static_cast<Eigen::Index>(i));
        if (!p.allFinite() || !somewhere(stage, i)) continue;
        const ImVec2 at = stage.seen(p).at;
        const ImU32 ink = faded(stage.scene.looks[i].colour, 0.45F * opacity);
        stage.list.AddLine(at, stage.discs[i].centre, faded(ink, 0.7F), stage.theme.hairline_px);
        stage.list.AddCircle(at, stage.discs[i].radius, ink, 0, stage.theme.hairline_px);
        if (stage.scene.arrows) draw_arrow_head(stage, at, stage.discs[i], faded(ink, 2.0F));
    }
}

void draw_points(const SpaceStage& stage, std::optional<std::size_t> hovered) {
    const Theme& theme = stage.theme;
    const float edge = 1.5F * theme.scale;
    std::vector<std::size_t> order = stage.front_to_back;
    std::ranges::stable_sort(order, {}, [&](std::size_t i) { return layer(stage, hovered, i); });
    for (auto it = order.rbegin(); it != order.rend(); ++it) {
        const std::size_t i = *it;
        const Disc& d = stage.discs[i];
        const bool marked = asked_for(stage, hovered, i);
        const bool selected = is_selected(stage, i);
        if (selected) {
            draw_selection_ring(stage.list, theme, d.centre, d.radius);
        } else if (marked || stage.chosen[i]) {
            const float wider = marked ? 4.0F : 3.0F;
            draw_disc(stage.list, theme, d.centre, d.radius + wider * theme.scale,
                      toned(stage, theme.text, marked ? 1.0F : presence(stage, i)));
            draw_disc(stage.list, theme, d.centre, d.radius + edge, theme.pane);
        } else {
            // A rim of the pane keeps neighbours apart; the ends of colour maps need one to be
            // seen.
            const bool is_seen =
                contrast(stage.scene.looks[i].colour, theme.pane) >= kLeastContrast;
            draw_disc(stage.list, theme, d.centre, d.radius + edge * 0.7F,
                      is_seen ? theme.pane : toned(stage, theme.dim_text, presence(stage, i)));
        }
        PatternLook look = stage.scene.looks[i];
        look.colour = toned(stage, look.colour, marked || selected ? 1.0F : presence(stage, i));
        draw_pattern_mark(stage.list, theme, d.centre, d.radius, look, theme.pane);
    }
}

}  // namespace tact
