// Two lines over the same stretch as one line between them.
//
// Output    points at every bend of either; where one jumps, two at one place
// Left out  bends of what is between two bent lines by ratio: straight between the points.
#pragma once

#include <functional>
#include <utility>
#include <vector>

namespace tact {

// A line over places from 0 to 1.
struct BentLine {
    std::vector<double> bends;           // besides 0 and 1, in any order
    std::function<double(double)> at{};  // its height
};

enum class BlendBy { difference, ratio };

// What is `share` of the way from a to b: 0 is a, 1 is b. By ratio where both are above 0.
double between(double a, double b, double share, BlendBy by);

// Places ascending, from 0 to 1, with heights.
std::vector<std::pair<double, double>> blended(const BentLine& a, const BentLine& b, double share,
                                               BlendBy by);

}  // namespace tact
