// Dynamic time warping: how far apart two signals are when either may wait for the other.
//
//     D[i,j] = |a_i - b_j| + min(D[i-1,j-1], D[i-1,j], D[i,j-1])
//
// Source    Berndt & Clifford 1994, as MATLAB's dtw(x, y): no window, no path normalisation.
// Input     two signals of any length; one of none is at distance 0 from another of none
// Output    the sum along the best path
// Left out  windows, slopes, other costs. No lower bounds: DTW is no metric.
// Exact     one |a-b|, two minima and one sum per cell, in any implementation: same 64 bits.
#pragma once

#include <span>
#include <stop_token>

namespace tact {

// Infinity where just one of the signals is empty. With a stop asked for, the result is
// meaningless and comes soon.
double dtw(std::span<const double> a, std::span<const double> b, std::stop_token stop = {});

}  // namespace tact
