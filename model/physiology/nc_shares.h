// The share of each channel, and of each two channels together, in the NC of a pair.
// N NC^2 = sum_c w_c^2 F_cc + sum_{c<d} 2 w_c w_d F_cd          (model/physiology/nc_matrix.h)
//
// Output    the terms relative to their sum, 1 in total: [c][c] of a channel alone, [c][d], c < d,
//           of two. A term of two is negative if they cancel each other. Zeros if the two brain
//           waveforms are equal.
#pragma once

#include "model/physiology/nc_matrix.h"

namespace tact {

using ChannelShares = std::array<PerReceptor<double>, kReceptorCount>;

ChannelShares nc_shares(const SpikeForm& form, const PerReceptor<double>& channel_weight);

}  // namespace tact
