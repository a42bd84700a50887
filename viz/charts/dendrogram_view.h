// A tree of groups as a dendrogram, upright: objects below, joins above them at their heights, and
// the line that cuts it.
//
// Input     a tree (model/map/group_tree.h), the look of each object's group, its name
// Output    what is pointed at, and where the line was put
// Valid     any number of objects: branches that are narrower than a pixel are drawn as one line;
//           names where each has room for its own
// Left out  folding branches by hand, and zooming.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "model/map/group_tree.h"
#include "viz/drawing/geometry.h"
#include "viz/drawing/theme.h"

namespace tact {

// Where branches stand, in objects from the left: the k-th object from 0 at k + 0.5, and a join in
// the middle between both of its branches. By the numbers of branches.
struct DendrogramPlaces {
    std::vector<std::size_t> order;  // objects from the left
    std::vector<double> x;           // 2 n - 1 of them

    bool operator==(const DendrogramPlaces&) const = default;
};
DendrogramPlaces dendrogram_places(const GroupTree& tree);

struct DendrogramScene {
    const GroupTree& tree;
    const DendrogramPlaces& places;
    std::span<const PatternLook> looks;  // of each object
    std::span<const std::string> names;  // of each object
    std::string_view title;              // above the axis: what heights are
    std::string_view words;              // on the line: "8 groups"
    double cut = 0.0;
    std::optional<std::size_t> lit{};  // an object
    bool stale = false;
};

struct DendrogramAction {
    std::optional<std::size_t> hovered{};  // an object
    std::optional<std::size_t> clicked{};  // an object, by its name or its foot
    std::optional<double> cut{};           // the line was put there
};

DendrogramAction draw_dendrogram(const char* id, const Theme& theme, const Rect& area,
                                 const DendrogramScene& scene);

// Where a height is on the screen: for tests of what is drawn.
float dendrogram_height_px(const Theme& theme, const Rect& area, const DendrogramScene& scene,
                           double height);

}  // namespace tact
