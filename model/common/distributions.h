// Student's t and Fisher's F, for tests and intervals of estimates.
//
// Source    t: Student 1908; of whole degrees of freedom a finite sum: Abramowitz & Stegun 1964,
//           26.7.3 and 26.7.4. F: a regularised incomplete beta (DLMF 8.17), by the continued
//           fraction DLMF 8.17.22 with Lentz's method; log gamma by Stirling's series (DLMF
//           5.11.1)
// Valid     F: degrees of freedom above 0, whole or not, up to 1e7; quantiles to 1e-10 relative
// Exact     same input, same bits, on any processor and instruction set
#pragma once

#include <cmath>
#include <cstddef>
#include <limits>
#include <span>

namespace tact {

// How often |T| is larger than |t| by chance; freedom 0: the normal distribution, as of infinitely
// many. NaN of NaN. Below 1e-15 it is rounding.
double two_sided_p(double t, std::size_t freedom);

// The t that |T| stays below with a probability of `coverage`, 0 <= coverage < 1.
double two_sided_quantile(double coverage, std::size_t freedom);

// The share of F(df1, df2) below a value; 0 below 0.
double f_share_below(double value, double df1, double df2);

// The value below which a share (0 < share < 1) lies.
double f_quantile(double share, double df1, double df2);

// What share of some numbers lies below.
//
// Source    Hyndman & Fan 1996, type 7: linear between the sorted values.

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

// The mean of numbers of which some are not known.

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
