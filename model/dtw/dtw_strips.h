// Distances of pairs side by side: their matrices strip by strip.
//
// Left out  threads, and more pairs than fit side by side: see dtw.h.
#pragma once

#include <span>
#include <stop_token>

#include "model/dtw/dtw.h"
#include "model/dtw/dtw_kernel.h"

namespace tact {

// One distance per pair, at so much for a sample of waiting, or infinities soon after a stop (a
// strip of 10,000 columns takes 0.1 ms). The pairs have to be of one shape: all a of one length,
// all b of one length; at most sweep.pairs.
void dtw_strips(const DtwSweep& sweep, std::span<const SignalPair> pairs, double waiting_cost,
                std::span<double> distances, const std::stop_token& stop);

}  // namespace tact
