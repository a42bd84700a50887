// What share of some numbers lies below.
//
// Source    Hyndman & Fan 1996, type 7: linear between the sorted values.
#pragma once

#include <cstddef>
#include <span>

namespace tact {

struct Interval {
    double low = 0.0;
    double high = 0.0;
};

// The value below which a share (0..1) of the sorted values lies. NaN of no values.
double quantile(std::span<const double> sorted, double share);

// Counts against shares that people type: 0.29 of 100 is 29, though 0.29 * 100 is less in binary.
// The rounding error that the product of a share and a count may have, in counts.
inline constexpr double kShareSpare = 1e-9;

// Whether `count` of `all` is no more than the share.
inline bool is_at_most_share(std::size_t count, double share, std::size_t all) {
    return static_cast<double>(count) <= share * static_cast<double>(all) + kShareSpare;
}

}  // namespace tact
