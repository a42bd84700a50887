#include "model/signal/thinning.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <queue>

namespace tact {

namespace {

// A straight line between two kept points, and what is farthest from it.
struct Stretch {
    std::size_t first;
    std::size_t last;
    std::size_t farthest;
    double error;
};

struct LessFar {
    // The earlier one first where two are equally far off.
    bool operator()(const Stretch& a, const Stretch& b) const {
        return a.error != b.error ? a.error < b.error : a.first > b.first;
    }
};

Stretch stretch_between(std::span<const double> places, std::span<const double> heights,
                        std::size_t first, std::size_t last) {
    Stretch stretch{first, last, first, 0.0};
    const double length = places[last] - places[first];
    for (std::size_t k = first + 1; k < last; ++k) {
        const double share = length > 0.0 ? (places[k] - places[first]) / length : 0.0;
        const double line = heights[first] + share * (heights[last] - heights[first]);
        const double error = std::abs(heights[k] - line);
        if (error > stretch.error) {
            stretch.farthest = k;
            stretch.error = error;
        }
    }
    return stretch;
}

}  // namespace

Thinning thinned(std::span<const double> places, std::span<const double> heights, std::size_t most,
                 double tolerance) {
    assert(places.size() == heights.size() && "a height for every place");
    const std::size_t n = places.size();
    if (n == 0) return {};
    if (n == 1) return {{0}, 0.0};
    Thinning thinning{{0, n - 1}, 0.0};
    std::priority_queue<Stretch, std::vector<Stretch>, LessFar> stretches;
    stretches.push(stretch_between(places, heights, 0, n - 1));
    while (thinning.kept.size() < most && stretches.top().error > tolerance) {
        const Stretch worst = stretches.top();
        stretches.pop();
        thinning.kept.push_back(worst.farthest);
        stretches.push(stretch_between(places, heights, worst.first, worst.farthest));
        stretches.push(stretch_between(places, heights, worst.farthest, worst.last));
    }
    std::ranges::sort(thinning.kept);
    thinning.largest_error = stretches.top().error;
    return thinning;
}

}  // namespace tact
