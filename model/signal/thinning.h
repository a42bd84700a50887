// A line of many points as one of few: Ramer, Douglas and Peucker's, the worst place first.
//
// Where the original splits until all is within a tolerance, this one splits where the line is
// farthest off until that, or until the points are used up: the error is known either way. What
// "farthest" means may be weighed: of equal weight the distance decides.
//
// Source    Ramer 1972; Douglas & Peucker 1973. Distance is that of the heights, not across: the
//           axes have different units.
// Input     as many heights as places, the places ascending
// Output    positions, ascending, the first and the last among them
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

namespace tact {

struct Thinning {
    std::vector<std::size_t> kept;
    double largest_error = 0.0;  // of any height, straight lines between those that are kept
    double largest_weight = 0.0;
};

// What it is worth that the line passes a place at another height; 0: nothing.
using ThinningWeight = std::function<double(std::size_t place, double line)>;

// At least two points of `most`, of which fewer are kept once all is within `tolerance`.
Thinning thinned(std::span<const double> places, std::span<const double> heights, std::size_t most,
                 double tolerance, const ThinningWeight& weight = {});

}  // namespace tact
