// The most even way through layers of places: one of each layer, in order, so that the distances
// between neighbours are as alike as can be.
//
// Input     layers of ascending shares of a way; a distance for any two shares of neighbouring
//           layers
// Output    for each layer the index of its place: the way within the tolerance whose shares are
//           spread most evenly; if there is no such way, the one with the smallest ratio of largest
//           to smallest distance
// Valid     distances at least 0
// Exact     same input, same way. Dynamic programming for each distance that could be the smallest
//           one (a bottleneck, then a sum of squares). If there are more than 1,500 distances, only
//           every n-th is tried as the smallest; narrowing makes up for it.
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

namespace tact {

struct EvenPath {
    std::vector<std::size_t> chosen;  // empty: there is no way with all distances above 0
    double ratio = 0.0;               // of the largest distance to the smallest
};

// `distance(layer, i, j)`: of place i of that layer to place j of the next one.
using LayerDistance = std::function<double(std::size_t layer, std::size_t i, std::size_t j)>;

EvenPath even_path(const std::vector<std::vector<double>>& layers, const LayerDistance& distance,
                   double tolerance);

}  // namespace tact
