// NC of many pairs: how far apart two brain waveforms are, from counts of coinciding spikes.
//
// With s_c = a_c - b_c the difference of the spikes of channel c, -1, 0 or 1 at every sample,
//     N NC^2 = sum_n (sum_c w_c s_c[n])^2 = sum_cd w_c w_d F_cd,      F_cd = sum_n s_c[n] s_d[n]
//     F_cd = |a_c & a_d| + |b_c & b_d| - |a_c & b_d| - |b_c & a_d|
// where |.| counts samples: 64 at a time, once the spikes are packed into words.
//
// Source    Lim & Park 2023, section 4.3 (RMSE of the predicted brain waveforms).
// Input     codes of one length, up to 1000 s
// Left out  other distances than the root mean square.
// Exact     whole numbers up to the last root: direct and packed form, a to b and b to a, and every
//           instruction set give the same bits.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "model/physiology/neural_coding.h"

namespace tact {

// F, symmetric.
using SpikeForm = std::array<PerReceptor<std::int64_t>, kReceptorCount>;

// Sample by sample.
SpikeForm spike_form(const NeuralCode& a, const NeuralCode& b);

// The central spikes of one pattern, one bit per sample.
struct PackedSpikes {
    std::size_t samples = 0;
    std::size_t words = 0;            // per channel up to its last spike, zero-padded
    std::vector<std::uint64_t> bits;  // channel by channel
    SpikeForm coincidences{};         // |a_c & a_d|
};

PackedSpikes packed_spikes(const NeuralCode& code);

SpikeForm spike_form(const PackedSpikes& a, const PackedSpikes& b);

// sqrt(sum_cd w_c w_d F_cd / N). Weights, within +-kLargestWeight, count to twelve decimals: their
// products are then whole numbers, and 0.1 + 0.2 cancels 0.3 as it should. Doubles would leave
// about 1e-17, and 3e-9 after the root: enough to order pairs that are equal.
double nc_dissimilarity(const SpikeForm& form, std::size_t samples,
                        const PerReceptor<double>& channel_weight);

// The same for two packed patterns.
double nc_dissimilarity(const PackedSpikes& a, const PackedSpikes& b,
                        const PerReceptor<double>& channel_weight);

inline constexpr double kLargestWeight = 1000.0;

// The weights in units of their last decimal.
PerReceptor<std::int64_t> whole_weights(const PerReceptor<double>& channel_weight);

// sqrt(unit^2 sum / samples), with one of those units; 0 without samples.
double root_mean_square(std::int64_t unit, std::int64_t sum, std::size_t samples);

// A weight as a whole number of 1 / kWeightUnits.
inline constexpr double kWeightUnits = 1e12;
std::int64_t weight_units(double weight);

// kReceptorCount rows of words.
struct SpikeRows {
    const std::uint64_t* bits = nullptr;
    std::size_t words = 0;  // of each row
};

// |a_c & b_d| as far as the shorter rows reach, for one instruction set.
struct CoincidenceCounter {
    const char* name;
    SpikeForm (*count)(const SpikeRows& a, const SpikeRows& b);
};

// Versions that this processor can run, the fastest first, which is in use.
std::span<const CoincidenceCounter> coincidence_counters();

// The share of each channel, and of each two channels together, in the NC of a pair.
// N NC^2 = sum_c w_c^2 F_cc + sum_{c<d} 2 w_c w_d F_cd
//
// Output    the terms relative to their sum, 1 in total: [c][c] of a channel alone, [c][d], c < d,
//           of two. A term of two is negative if they cancel each other. Zeros if the two brain
//           waveforms are equal.

using ChannelShares = std::array<PerReceptor<double>, kReceptorCount>;

ChannelShares nc_shares(const SpikeForm& form, const PerReceptor<double>& channel_weight);

}  // namespace tact
