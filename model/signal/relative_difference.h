// How much of two signals they do not have in common: 0 the same, 1 nothing.
//
//     sum |a - b| / sum (|a| + |b|)
//
// Source    ours, not the paper's; for signals >= 0 it is the dissimilarity of Bray & Curtis 1957.
// Left out  shifts: a signal and the same one later differ.
#pragma once

#include <span>

namespace tact {

// Where one signal is shorter, zeros follow. Two silent signals are the same: 0.
double relative_difference(std::span<const double> a, std::span<const double> b);

}  // namespace tact
