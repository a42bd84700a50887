// A first look along the way from one pattern to another. Private to the room.
#pragma once

#include <optional>
#include <vector>

#include "model/ask/path_distances.h"

namespace tact {

// The whole way, bisected where it goes far.
struct PathOverview {
    std::vector<double> shares;
    std::vector<double> coarse;  // of all pairs, row by row; the lower half is 0
};

// False when stopped. Distances of the path have their scale from then on.
bool look_over(PathDistances& path, PathOverview& overview);

// All its coarse distances by the scale that the path has now.
void measure(const PathDistances& path, PathOverview& overview);

// Each with the next one.
PathDistances::Pairs neighbours_of(const std::vector<double>& shares);

// Where the way goes farthest at once; none when stopped.
std::optional<PathJump> largest_jump(PathDistances& path, const PathOverview& overview);

}  // namespace tact
