// Student's t, for estimates whose standard error is itself estimated.
//
// Source    Student 1908; of whole degrees of freedom a finite sum: Abramowitz & Stegun
//           1964, 26.7.3 and 26.7.4
// Input     degrees of freedom; 0: the normal distribution, as of infinitely many
// Exact     same input, same bits, on any processor.
#pragma once

#include <cstddef>

namespace tact {

// How often |T| is larger than |t| by chance. NaN of NaN. Below 1e-15 it is rounding.
double two_sided_p(double t, std::size_t freedom);

// The t that |T| stays below with a probability of `coverage`, 0 <= coverage < 1.
double two_sided_quantile(double coverage, std::size_t freedom);

}  // namespace tact
