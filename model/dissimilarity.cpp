#include "model/dissimilarity.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numeric>

namespace tact {

double Dissimilarity::operator()(std::size_t i, std::size_t j) const {
    assert(i < size && j < size && "object outside the matrix");
    if (i == j) return 0.0;
    return condensed[pair_index(size, std::min(i, j), std::max(i, j))];
}

std::pair<std::size_t, std::size_t> pair_at(std::size_t n, std::size_t index) {
    assert(index < pair_count(n) && "pair outside the matrix");
    // Row i starts at i (2n - i - 1) / 2; solve for i, then correct the rounding.
    const double b = 2.0 * static_cast<double>(n) - 1.0;
    const double root = std::sqrt(b * b - 8.0 * static_cast<double>(index));
    auto i = static_cast<std::size_t>((b - root) / 2.0);
    while (i > 0 && pair_index(n, i, i + 1) > index) --i;
    while (i + 2 < n && pair_index(n, i + 1, i + 2) <= index) ++i;
    return {i, index - pair_index(n, i, i + 1) + i + 1};
}

std::vector<double> quantised(std::span<const double> values) {
    double largest = 1e-6;
    for (const double value : values) largest = std::max(largest, std::abs(value));
    std::vector<double> result(values.size());
    std::ranges::transform(values, result.begin(),
                           [largest](double value) { return std::round(value / largest * 1e9); });
    return result;
}

std::vector<double> average_ranks(std::span<const double> values) {
    const std::vector<double> keys = quantised(values);
    std::vector<std::size_t> order(keys.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::sort(order, [&keys](std::size_t a, std::size_t b) { return keys[a] < keys[b]; });
    std::vector<double> ranks(keys.size());
    for (std::size_t first = 0; first < order.size();) {
        std::size_t end = first + 1;
        while (end < order.size() && keys[order[end]] == keys[order[first]]) ++end;
        // Ranks first + 1 .. end share their mean.
        const double rank = static_cast<double>(first + 1 + end) / 2.0;
        for (std::size_t k = first; k < end; ++k) ranks[order[k]] = rank;
        first = end;
    }
    return ranks;
}

}  // namespace tact
