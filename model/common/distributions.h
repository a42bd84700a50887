// Student's t and Fisher's F, for tests and intervals of estimates.
//
// Source    t: Student 1908; of whole degrees of freedom a finite sum: Abramowitz & Stegun 1964,
//           26.7.3 and 26.7.4. F: a regularised incomplete beta (DLMF 8.17), by the continued
//           fraction DLMF 8.17.22 with Lentz's method; log gamma by Stirling's series (DLMF
//           5.11.1)
// Valid     F: degrees of freedom above 0, whole or not, up to 1e7; quantiles to 1e-10 relative
// Exact     same input, same bits, on any processor and instruction set
#pragma once

#include <cstddef>

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

}  // namespace tact
