#include "model/signal/relative_difference.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace tact {

double relative_difference(std::span<const double> a, std::span<const double> b) {
    double apart = 0.0;
    double all = 0.0;
    for (std::size_t k = 0; k < std::max(a.size(), b.size()); ++k) {
        const double left = k < a.size() ? a[k] : 0.0;
        const double right = k < b.size() ? b[k] : 0.0;
        apart += std::abs(left - right);
        all += std::abs(left) + std::abs(right);
    }
    return all > 0.0 ? apart / all : 0.0;
}

}  // namespace tact
