#include "model/common/quantile.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace tact {

double quantile(std::span<const double> sorted, double share) {
    if (sorted.empty()) return std::numeric_limits<double>::quiet_NaN();
    double place = std::clamp(share, 0.0, 1.0) * static_cast<double>(sorted.size() - 1);
    // 0.29 of 100 is less than 29 in binary, and would miss the value itself.
    if (std::abs(place - std::round(place)) <= kShareSpare) place = std::round(place);
    const auto below = static_cast<std::size_t>(place);
    const std::size_t above = std::min(below + 1, sorted.size() - 1);
    return sorted[below] + (place - static_cast<double>(below)) * (sorted[above] - sorted[below]);
}

}  // namespace tact
