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
    double weight;
    double largest_error;  // of any, not only of the farthest
};

struct LessFar {
    // The earlier one first where two are equally far off.
    bool operator()(const Stretch& a, const Stretch& b) const {
        if (a.weight != b.weight) return a.weight < b.weight;
        return a.error != b.error ? a.error < b.error : a.first > b.first;
    }
};

Stretch stretch_between(std::span<const double> places, std::span<const double> heights,
                        std::size_t first, std::size_t last, const ThinningWeight& weight) {
    Stretch stretch{first, last, first, 0.0, 0.0, 0.0};
    const double length = places[last] - places[first];
    for (std::size_t k = first + 1; k < last; ++k) {
        const double share = length > 0.0 ? (places[k] - places[first]) / length : 0.0;
        const double line = heights[first] + share * (heights[last] - heights[first]);
        const double error = std::abs(heights[k] - line);
        const double own_weight = weight && error > 0.0 ? weight(k, line) : 0.0;
        stretch.largest_error = std::max(stretch.largest_error, error);
        const bool farther =
            own_weight != stretch.weight ? own_weight > stretch.weight : error > stretch.error;
        if (farther) {
            stretch.farthest = k;
            stretch.error = error;
            stretch.weight = own_weight;
        }
    }
    return stretch;
}

}  // namespace

Thinning thinned(std::span<const double> places, std::span<const double> heights, std::size_t most,
                 double tolerance, const ThinningWeight& weight) {
    assert(places.size() == heights.size() && "a height for every place");
    const std::size_t n = places.size();
    if (n == 0) return {};
    if (n == 1) return {{0}, 0.0, 0.0};
    Thinning thinning{{0, n - 1}, 0.0, 0.0};
    std::priority_queue<Stretch, std::vector<Stretch>, LessFar> stretches;
    stretches.push(stretch_between(places, heights, 0, n - 1, weight));
    while (thinning.kept.size() < most && stretches.top().error > tolerance) {
        const Stretch worst = stretches.top();
        stretches.pop();
        thinning.kept.push_back(worst.farthest);
        stretches.push(stretch_between(places, heights, worst.first, worst.farthest, weight));
        stretches.push(stretch_between(places, heights, worst.farthest, worst.last, weight));
    }
    std::ranges::sort(thinning.kept);
    thinning.largest_weight = stretches.top().weight;
    for (; !stretches.empty(); stretches.pop()) {
        thinning.largest_error = std::max(thinning.largest_error, stretches.top().largest_error);
    }
    return thinning;
}

}  // namespace tact
