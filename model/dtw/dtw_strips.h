// Distances of pairs side by side: their matrices strip by strip.
//
// Left out  more pairs than fit side by side: see dtw.h.
#pragma once

#include <span>
#include <stop_token>

#include "model/dtw/dtw.h"
#include "model/dtw/dtw_kernel.h"

namespace tact {

// One distance per pair, or infinities soon after a stop (a strip of 10,000 columns takes 0.1 ms).
// At most sweep.pairs. Signals shorter than the longest of their side are filled up with zeros at
// their end, which changes no bit where TrimmedPair::may_be_padded says so. With several threads
// a long pair is computed by all of them, at most a tenth dearer from 20,000 samples on.
void dtw_strips(const DtwSweep& sweep, std::span<const SignalPair> pairs, double waiting_cost,
                std::span<double> distances, const std::stop_token& stop, int threads = 1);

}  // namespace tact
