// The way through dynamic time warping: which moment of one signal is taken for which of the other.
//
//     D[i,j] = |a_i - b_j| + min(D[i-1,j-1], min(D[i-1,j], D[i,j-1]) + w)
//
// traced back from the end; of equal ways the diagonal one, then the one that lets b wait.
//
// Source    Sakoe & Chiba 1978; cost and steps as in model/dtw/dtw.h.
// Input     two signals, both with samples or both empty; what a sample of waiting costs
// Output    pairs of positions from (0, 0) to the last of both, each one step on from the last
// Valid     finite values; memory of one byte a cell, so coarse signals for long ones
// Exact     same input, same bits; `distance` is that of dtw().
#pragma once

#include <cstddef>
#include <span>
#include <utility>
#include <vector>

namespace tact {

struct DtwPath {
    double distance = 0.0;
    std::vector<std::pair<std::size_t, std::size_t>> steps;
};

DtwPath dtw_path(std::span<const double> a, std::span<const double> b, double waiting_cost = 0.0);

}  // namespace tact
