#include "model/dissimilarity/dissimilarity.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <limits>
#include <numeric>

namespace tact {

namespace {

constexpr double kLeastLargest = 1e-6;

double largest_size(std::span<const double> values) {
    double largest = kLeastLargest;
    for (const double value : values) largest = std::max(largest, std::abs(value));
    return largest;
}

double quantised(double value, double largest) { return std::round(value / largest * 1e9); }

// Keys are whole and within 1e9.
constexpr double kLowestKey = -1e9;

// Sorting by digits takes a tenth of the time of comparing, where its counters are worth their
// while; with more values than this, the memory for a second copy is worth more.
constexpr std::size_t kFewestByDigits = 4096;
constexpr std::size_t kMostByDigits = 1U << 23U;

void sort_by_digits(std::vector<KeyedPlace>& order) {
    constexpr unsigned kBitsOfDigit = 11;  // three digits hold keys of up to 2e9
    constexpr std::size_t kDigitCount = 1U << kBitsOfDigit;
    std::vector<KeyedPlace> sorted(order.size());
    for (unsigned shift = 0; shift < 3 * kBitsOfDigit; shift += kBitsOfDigit) {
        const auto digit = [shift](const KeyedPlace& one) {
            return one.key >> shift & (kDigitCount - 1);
        };
        std::array<std::size_t, kDigitCount + 1> begin{};
        for (const KeyedPlace& one : order) ++begin[digit(one) + 1];
        std::partial_sum(begin.begin(), begin.end(), begin.begin());
        for (const KeyedPlace& one : order) sorted[begin[digit(one)]++] = one;
        order.swap(sorted);
    }
}

// The finite values by their quantised distance from `origin`, ascending.
std::vector<KeyedPlace> in_order(std::span<const double> values, double origin, double largest) {
    assert(values.size() <= std::numeric_limits<std::uint32_t>::max() && "places take 32 bits");
    std::vector<KeyedPlace> order;
    order.reserve(values.size());
    for (std::size_t k = 0; k < values.size(); ++k) {
        if (!std::isfinite(values[k])) continue;
        const double key = quantised(values[k] - origin, largest) - kLowestKey;
        order.push_back({static_cast<std::uint32_t>(key), static_cast<std::uint32_t>(k)});
    }
    if (order.size() >= kFewestByDigits && order.size() <= kMostByDigits) {
        sort_by_digits(order);
    } else {
        std::ranges::sort(order);
    }
    return order;
}

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

void tie_rounding_noise(std::vector<double>& values, double origin) {
    const auto size_of = [&](std::size_t k) { return std::abs(values[k] - origin); };
    double largest = kLeastLargest;
    for (std::size_t k = 0; k < values.size(); ++k) {
        if (std::isfinite(values[k])) largest = std::max(largest, size_of(k));
    }
    const std::vector<KeyedPlace> order = in_order(values, origin, largest);
    for (std::size_t first = 0, end = 0; first < order.size(); first = end) {
        std::size_t farthest = order[first].place;
        for (end = first; end < order.size() && order[end].key == order[first].key; ++end) {
            if (size_of(order[end].place) > size_of(farthest)) farthest = order[end].place;
        }
        // What is nothing but rounding is nothing.
        const bool is_nothing = static_cast<double>(order[first].key) == -kLowestKey;
        const double one = is_nothing ? origin : values[farthest];
        for (std::size_t k = first; k < end; ++k) values[order[k].place] = one;
    }
}

std::vector<KeyedPlace> by_size(std::span<const double> values) {
    double largest = kLeastLargest;
    for (const double value : values) {
        if (std::isfinite(value)) largest = std::max(largest, std::abs(value));
    }
    return in_order(values, 0.0, largest);
}

std::vector<double> average_ranks(std::span<const double> values) {
    std::vector<double> ranks(values.begin(), values.end());
    replace_by_ranks(ranks);
    return ranks;
}

void replace_by_ranks(std::vector<double>& values) {
    for (const double value : values) {
        assert(std::isfinite(value) && "only numbers have ranks");
        static_cast<void>(value);
    }
    const std::vector<KeyedPlace> order = in_order(values, 0.0, largest_size(values));
    for (std::size_t first = 0; first < order.size();) {
        std::size_t end = first + 1;
        while (end < order.size() && order[end].key == order[first].key) ++end;
        // Ranks first + 1 .. end share their mean.
        const double rank = static_cast<double>(first + 1 + end) / 2.0;
        for (std::size_t k = first; k < end; ++k) values[order[k].place] = rank;
        first = end;
    }
}

}  // namespace tact
