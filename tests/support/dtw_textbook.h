// DTW as the textbooks print it, the reference of tests and benchmarks: two rows, one cell at a
// time. Every other implementation has to give its bits.
//
//     D[i,j] = |a_i - b_j| + min(D[i-1,j-1], min(D[i-1,j], D[i,j-1]) + w)
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <vector>

namespace tact {

inline double dtw_textbook(std::span<const double> a, std::span<const double> b,
                           double waiting_cost = 0.0) {
    if (a.empty() && b.empty()) return 0.0;
    constexpr double kNowhere = std::numeric_limits<double>::infinity();
    // One row: row[j + 1] is D[i-1, j] before and D[i, j] after its update; row[0] lies outside.
    std::vector<double> row(b.size() + 1, kNowhere);
    double above_left = 0.0;  // D[i-1, j-1]; the path starts at no cost before the first cell
    for (const double value : a) {
        double left = kNowhere;
        for (std::size_t j = 0; j < b.size(); ++j) {
            const double above = row[j + 1];
            const double cheapest = std::min(above_left, std::min(above, left) + waiting_cost);
            left = std::abs(value - b[j]) + cheapest;
            row[j + 1] = left;
            above_left = above;
        }
        above_left = kNowhere;
    }
    return row.back();
}

}  // namespace tact
