#include "model/dissimilarity/dissimilarity.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <limits>

namespace tact {

namespace {

double largest_size(std::span<const double> values) {
    double largest = 1e-6;
    for (const double value : values) largest = std::max(largest, std::abs(value));
    return largest;
}

double quantised(double value, double largest) { return std::round(value / largest * 1e9); }

}  // namespace

double Dissimilarity::operator()(std::size_t i, std::size_t j) const {
    assert(i < size && j < size && "object outside the matrix");
    if (i == j) return 0.0;
    return condensed[pair_index(size, std::min(i, j), std::max(i, j))];
}

Dissimilarity among(const Dissimilarity& dissimilarity, std::span<const std::size_t> objects) {
    Dissimilarity result{objects.size(), {}};
    for (std::size_t i = 0; i < objects.size(); ++i) {
        for (std::size_t j = i + 1; j < objects.size(); ++j) {
            result.condensed.push_back(dissimilarity(objects[i], objects[j]));
        }
    }
    return result;
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
    const double largest = largest_size(values);
    std::vector<double> result(values.size());
    std::ranges::transform(values, result.begin(),
                           [largest](double value) { return quantised(value, largest); });
    return result;
}

bool is_zero_among(std::span<const double> values, std::size_t place) {
    return quantised(values[place], largest_size(values)) == 0.0;
}

void tie_rounding_noise(std::vector<double>& values) {
    const double largest = largest_size(values);
    for (double& value : values) value = quantised(value, largest) * largest / 1e9;
}

std::vector<double> average_ranks(std::span<const double> values) {
    std::vector<double> ranks(values.begin(), values.end());
    replace_by_ranks(ranks);
    return ranks;
}

void replace_by_ranks(std::vector<double>& values) {
    // Key and place in one word: half the memory of keys and an order apart, and sorting does not
    // jump about in it. Keys are whole and within 1e9.
    assert(values.size() <= std::numeric_limits<std::uint32_t>::max() && "places take 32 bits");
    constexpr double kLowest = -1e9;
    const double largest = largest_size(values);
    std::vector<std::uint64_t> order(values.size());
    for (std::size_t k = 0; k < values.size(); ++k) {
        assert(std::isfinite(values[k]) && "only numbers have ranks");
        order[k] = static_cast<std::uint64_t>(quantised(values[k], largest) - kLowest) << 32U | k;
    }
    std::ranges::sort(order);
    for (std::size_t first = 0; first < order.size();) {
        std::size_t end = first + 1;
        while (end < order.size() && order[end] >> 32U == order[first] >> 32U) ++end;
        // Ranks first + 1 .. end share their mean.
        const double rank = static_cast<double>(first + 1 + end) / 2.0;
        for (std::size_t k = first; k < end; ++k) values[order[k] & 0xffffffffU] = rank;
        first = end;
    }
}

}  // namespace tact
