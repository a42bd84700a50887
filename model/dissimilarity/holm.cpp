#include "model/dissimilarity/holm.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace tact {

std::vector<double> holm(std::span<const double> p) {
    std::vector<std::size_t> rising;
    for (std::size_t k = 0; k < p.size(); ++k) {
        if (!std::isnan(p[k])) rising.push_back(k);
    }
    std::ranges::stable_sort(rising, {}, [p](std::size_t k) { return p[k]; });
    std::vector<double> corrected(p.begin(), p.end());
    double before = 0.0;
    for (std::size_t k = 0; k < rising.size(); ++k) {
        const auto left = static_cast<double>(rising.size() - k);
        before = std::max(before, std::min(1.0, left * p[rising[k]]));
        corrected[rising[k]] = before;
    }
    return corrected;
}

}  // namespace tact
