// The order in which pairs of signals are compared: side by side in a register where that is
// cheaper, the costliest first, so that all threads end at about the same time.
//
// Exact     the order and the registers change no bit of a distance.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "model/dtw/dtw.h"
#include "model/dtw/dtw_kernel.h"

namespace tact {

// A pair without the zeros that change no bit of its distance, the signal of more samples first.
//
// Where waiting is free and both signals end in a zero, zeros behind it cost nothing: rounding is
// monotonic, so a row of a second zero is nowhere below the row of the first. The same holds at the
// beginning. It does not hold if only one of the two has a zero there.
struct TrimmedPair {
    SignalPair signals;
    bool may_be_padded = false;  // by any number of zeros at the end of either
};

TrimmedPair trimmed(const SignalPair& pair, double waiting_cost);

// The same of all pairs. A signal is looked at once, however many pairs it is in.
std::vector<TrimmedPair> trimmed(std::span<const SignalPair> pairs, double waiting_cost);

// Pairs that one thread computes in one go.
struct DtwBatch {
    std::size_t first = 0;  // position in DtwBatches::order
    std::size_t count = 0;
    bool side_by_side = false;
    double cost = 0.0;  // cells of a register, lanes without a pair included
};

struct DtwBatches {
    std::vector<std::size_t> order;  // of the pairs
    std::vector<DtwBatch> all;       // the costliest first
};

DtwBatches dtw_batches(std::span<const TrimmedPair> pairs, const DtwKernel& kernel,
                       std::size_t threads);

}  // namespace tact
