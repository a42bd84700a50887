// Dynamic time warping: how far apart two signals are when either may wait for the other.
//
//     D[i,j] = |a_i - b_j| + min(D[i-1,j-1], min(D[i-1,j], D[i,j-1]) + w)
//
// w is what a sample of waiting costs, in the signals' unit: 0, unless it is asked for.
//
// Source    Berndt & Clifford 1994, as MATLAB's dtw(x, y): no window, no path normalisation. A cost
//           added to steps that wait: Clifford et al. 2009, "Alignment using variable penalty
//           dynamic time warping".
// Input     two signals of any length; one of none is at distance 0 from another of none
// Output    the sum along the best path; infinity where just one of the signals is empty
// Valid     finite values
// Left out  windows, slopes, other costs. No lower bounds: DTW is no metric.
// Exact     one |a-b|, two minima and one sum per cell (two, where waiting costs), in any
//           implementation: same 64 bits with every instruction set and number of threads, alone or
//           among other pairs.
#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <span>
#include <stop_token>
#include <utility>
#include <vector>

#include "model/dtw/dtw_kernel.h"

namespace tact {

// With a stop asked for, infinity, and soon.
double dtw(std::span<const double> a, std::span<const double> b, std::stop_token stop = {});

// Two signals. Either may count for more samples than it has values: zeros follow them, which
// nobody has to keep.
struct SignalPair {
    std::span<const double> a;
    std::span<const double> b;
    std::size_t a_samples = 0;  // default: those of its values
    std::size_t b_samples = 0;

    std::size_t rows() const { return std::max(a.size(), a_samples); }
    std::size_t columns() const { return std::max(b.size(), b_samples); }
};

struct DtwOptions {
    int threads = 0;            // 0: all cores
    double waiting_cost = 0.0;  // of a sample, at least 0
    std::stop_token stop = {};
    std::function<void(double)> progress = {};  // share of the work done, 0..1, from any thread
};

// The distance of every pair, in their order; pairs of any lengths may be mixed. Up to twice as
// fast as one by one, since pairs of similar lengths are taken side by side. Zeros at the ends of
// both signals cost nothing: a pair costs the product of its own two lengths (dtw_batches.h). With
// a stop asked for, some distances are infinity, and it returns soon.
std::vector<double> dtw(std::span<const SignalPair> pairs, const DtwOptions& options = {},
                        const DtwKernel& kernel = dtw_kernel());

// The way through dynamic time warping: which moment of one signal is taken for which of the other.
//
//     D[i,j] = |a_i - b_j| + min(D[i-1,j-1], min(D[i-1,j], D[i,j-1]) + w)
//
// traced back from the end; of equal ways the diagonal one, then the one that lets b wait.
//
// Source    Sakoe & Chiba 1978; cost and steps are those of dtw().
// Input     two signals, both with samples or both empty; what a sample of waiting costs
// Output    pairs of positions from (0, 0) to the last of both, each one step on from the last
// Valid     finite values; memory of one byte a cell, so coarse signals for long ones
// Exact     same input, same bits; `distance` is that of dtw().

struct DtwPath {
    double distance = 0.0;
    std::vector<std::pair<std::size_t, std::size_t>> steps;
};

DtwPath dtw_path(std::span<const double> a, std::span<const double> b, double waiting_cost = 0.0);

}  // namespace tact
