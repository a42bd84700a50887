// The parts a space is drawn from. Private to the space view.
#pragma once

#include <optional>
#include <span>

#include "viz/space/space_stage.h"

namespace tact {

// Behind the points (space_ground.cpp). The cross of axes and the scale bar return what they cover.
void draw_floor(const SpaceStage& stage, const SpaceCamera& camera);
void draw_shadows(const SpaceStage& stage);
void draw_drop_lines(const SpaceStage& stage, std::optional<std::size_t> hovered);
Rect draw_axes_cross(const SpaceStage& stage, const SpaceCamera& camera);
Rect draw_scale_bar(const SpaceStage& stage, const Rect& cross);  // beside the cross

// The axis whose name in the cross is there, 3 for its middle; none: neither.
std::optional<int> axis_at(const SpaceStage& stage, const SpaceCamera& camera, ImVec2 at);

// The points and what joins and surrounds them (space_points.cpp).
void draw_paths(const SpaceStage& stage);
void draw_links(const SpaceStage& stage);
void draw_spread(const SpaceStage& stage);

// The ellipse round a point that holds half of its moves, of any distribution and centre: it is
// where this matrix takes the unit circle. Its shape is that of their second moments about the
// point. None of no moves.
std::optional<Eigen::Matrix2d> half_ellipse(const Eigen::Matrix2Xd& moves);
void draw_ghosts(const SpaceStage& stage);
void draw_points(const SpaceStage& stage, std::optional<std::size_t> hovered);

// What is no pattern yet (space_view.cpp).
void draw_cloud(const SpaceStage& stage);
void draw_track(const SpaceStage& stage, std::optional<std::size_t> on_track);
void draw_proposals(const SpaceStage& stage, std::optional<std::size_t> pointed);
void draw_wanted(const SpaceStage& stage);

// What is written over them (space_names.cpp): names where they have room beside what is occupied,
// and the dissimilarity of a pair, whose plate is returned.
void draw_pair_line(const SpaceStage& stage, std::size_t a, std::size_t b);
Rect draw_pair_value(const SpaceStage& stage, std::size_t a, std::size_t b);
void draw_names(const SpaceStage& stage, std::span<const Rect> occupied,
                std::optional<std::size_t> hovered);

}  // namespace tact
