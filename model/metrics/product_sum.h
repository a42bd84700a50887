// The sum of the products of two signals, sample by sample.
//
// Exact     from the first sample to the last: one order, one result.
#pragma once

#include <cassert>
#include <cstddef>
#include <span>

namespace tact {

inline double product_sum(std::span<const double> a, std::span<const double> b) {
    assert(a.size() == b.size() && "signals of different lengths");
    double sum = 0.0;
    for (std::size_t n = 0; n < a.size(); ++n) sum += a[n] * b[n];
    return sum;
}

}  // namespace tact
