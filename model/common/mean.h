// The mean of numbers of which some are not known.
#pragma once

#include <cmath>
#include <limits>
#include <span>

namespace tact {

// Mean of the values that are not NaN; NaN if all are.
inline double mean_known(std::span<const double> values) {
    double sum = 0.0;
    std::size_t known = 0;
    for (const double value : values) {
        if (std::isnan(value)) continue;
        sum += value;
        ++known;
    }
    if (known == 0) return std::numeric_limits<double>::quiet_NaN();
    return sum / static_cast<double>(known);
}

}  // namespace tact
