// P-values of several tests at once.
//
// Source    Holm 1979: the k-th smallest of m is multiplied by m - k + 1; none falls below one that
//           was smaller. The chance of any false finding stays below the level.
// Input     p; NaN: there is no such test, and it does not count
// Left out  what assumes independent tests (Hochberg 1988): metrics of one set are not.
#pragma once

#include <span>
#include <vector>

namespace tact {

std::vector<double> holm(std::span<const double> p);

}  // namespace tact
