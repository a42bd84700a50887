// What share of some numbers lies below.
//
// Source    Hyndman & Fan 1996, type 7: linear between the sorted values.
#pragma once

#include <span>

namespace tact {

struct Interval {
    double low = 0.0;
    double high = 0.0;
};

// The value below which a share (0..1) of the sorted values lies. NaN of no values.
double quantile(std::span<const double> sorted, double share);

}  // namespace tact
