#include "model/dtw.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace tact {

double dtw(std::span<const double> a, std::span<const double> b, std::stop_token stop) {
    if (a.empty() && b.empty()) return 0.0;
    constexpr double kNowhere = std::numeric_limits<double>::infinity();
    // One row: row[j + 1] is D[i-1, j] before and D[i, j] after its update; row[0] lies outside.
    std::vector<double> row(b.size() + 1, kNowhere);
    double above_left = 0.0;  // D[i-1, j-1]; the path starts at no cost before the first cell
    for (const double value : a) {
        if (stop.stop_requested()) return kNowhere;
        double left = kNowhere;
        for (std::size_t j = 0; j < b.size(); ++j) {
            const double above = row[j + 1];
            const double cheapest = std::min(std::min(above_left, above), left);
            left = std::abs(value - b[j]) + cheapest;
            row[j + 1] = left;
            above_left = above;
        }
        above_left = kNowhere;
    }
    return row.back();
}

}  // namespace tact
