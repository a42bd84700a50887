#include "model/export/ranks_among.h"

#include <algorithm>
#include <cmath>

#include "model/dissimilarity/dissimilarity.h"

namespace tact {

std::vector<double> ranks_among(std::span<const double> values, std::span<const double> others) {
    // As quantised() has it, by the largest of the others.
    double largest = 1e-6;
    for (const double other : others) largest = std::max(largest, std::abs(other));
    std::vector<double> keys = quantised(others);
    std::ranges::sort(keys);
    std::vector<double> ranks;
    ranks.reserve(values.size());
    for (const double value : values) {
        const auto [first, last] =
            std::equal_range(keys.begin(), keys.end(), std::round(value / largest * 1e9));
        const auto below = static_cast<double>(first - keys.begin());
        ranks.push_back(below + (static_cast<double>(last - first) + 1.0) / 2.0);
    }
    return ranks;
}

}  // namespace tact
