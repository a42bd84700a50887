// A symmetric matrix with a zero diagonal, kept as its m = n(n-1)/2 pairs in condensed order
// (1,2),(1,3)..(1,n),(2,3)..
#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace tact {

struct Dissimilarity {
    std::size_t size = 0;           // n, number of objects
    std::vector<double> condensed;  // m values

    // The value of a pair in either order; 0 on the diagonal.
    double operator()(std::size_t i, std::size_t j) const;

    bool operator==(const Dissimilarity&) const = default;
};

// Those of some of the objects alone (ascending), in their order.
Dissimilarity among(const Dissimilarity& dissimilarity, std::span<const std::size_t> objects);

constexpr std::size_t pair_count(std::size_t objects) {
    return objects == 0 ? 0 : objects * (objects - 1) / 2;
}

// Position of the pair (i, j), i < j, among n objects.
constexpr std::size_t pair_index(std::size_t n, std::size_t i, std::size_t j) {
    return i * (2 * n - i - 1) / 2 + (j - i - 1);
}

// The pair (i, j), i < j, at a position.
std::pair<std::size_t, std::size_t> pair_at(std::size_t n, std::size_t index);

// d <- round(d / max(max |d|, 1e-6) 1e9), so that rounding noise makes no order.
std::vector<double> quantised(std::span<const double> values);

// Where a value stands, and its quantised form counted from the least that there can be.
struct KeyedPlace {
    std::uint32_t key = 0;
    std::uint32_t place = 0;

    auto operator<=>(const KeyedPlace&) const = default;
};

// The finite values by their quantised form, ascending; equal ones in their own order.
std::vector<KeyedPlace> by_size(std::span<const double> values);

// Values that differ by rounding noise alone, and so share a rank, become one of them: the one
// farthest from `origin`, or `origin` where they are next to nothing. All others keep their bits,
// so that ranks computed elsewhere from the values equal ours. Values that are not finite stay.
// Memory doubles meanwhile. `origin`: the zero of quantisation.
void tie_rounding_noise(std::vector<double>& values, double origin = 0.0);

// Whether a value is 0 among the others but for rounding noise, as its rank has it.
bool is_zero_among(std::span<const double> values, std::size_t place);

// Ranks 1..m of the quantised values; ties share their average rank.
std::vector<double> average_ranks(std::span<const double> values);

// The same in the values' own place, for matrices that fill the memory: as much again is
// needed meanwhile.
void replace_by_ranks(std::vector<double>& values);

}  // namespace tact
