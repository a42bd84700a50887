// A space's scene as it stands on the screen in one frame: where each point is, how large, how far
// back. Private to the space view.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "viz/space/space_view.h"

namespace tact {

struct SpaceStage {
    ImDrawList& list;
    const Theme& theme;
    const Rect& pane;
    const SpaceScene& scene;
    SpaceFit fit;
    SpaceProjection seen{};
    std::vector<Projected> projected;  // by point
    std::vector<Disc> discs;           // by point
    // Only points that can be seen, by layer and then by depth.
    std::vector<std::size_t> front_to_back;
    std::vector<bool> chosen;          // by point
    std::vector<bool> faint;           // by point
    std::vector<bool> selected_too{};  // by point
    std::vector<Disc> proposals{};     // of the scene's maybes
    std::vector<ImVec2> track{};
    std::vector<ImVec2> cloud{};
};

SpaceStage staged(ImDrawList& list, const Theme& theme, const Rect& pane, const SpaceScene& scene);

// Fills the points' places for a camera, again if it was moved.
void place_points(SpaceStage& stage, const SpaceCamera& camera);

// 0 (far) to 1 (near) within the map.
float nearness(const SpaceStage& stage, std::size_t i);

// How far a point steps back into the pane's colour: by depth, and if others were chosen.
float presence(const SpaceStage& stage, std::size_t i);

// The colour as it appears with a strength of 0 (the pane) to 1. Not by opacity: what lies behind a
// point must not shine through.
ImU32 toned(const SpaceStage& stage, ImU32 colour, float strength);

// A point without finite coordinates is nowhere.
bool somewhere(const SpaceStage& stage, std::size_t i);

bool visible(const SpaceStage& stage, const Disc& disc);

// The selected point, or the one under the mouse.
bool asked_for(const SpaceStage& stage, std::optional<std::size_t> hovered, std::size_t i);

// It, or one of those beside it.
bool is_selected(const SpaceStage& stage, std::size_t i);

// Beside a subset chosen from many, the others are a cloud without names and drop lines.
bool is_cloud(const SpaceStage& stage, std::size_t i);

// What lies over what, whatever its depth, 0 on top: the selected point, others that are selected,
// chosen ones, the hovered one, others, and those that were filtered out or are a cloud. A ring
// would else frame the point before its own.
int layer(const SpaceStage& stage, std::optional<std::size_t> hovered, std::size_t i);

}  // namespace tact
