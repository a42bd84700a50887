// Spikes of a receptor from the energy of the vibration it perceives.
//
// A receptor fires each time the energy since its last spike reaches E_thr = energy / fires,
// compared every 10 ms, with the rest carried over. With C_j the share of the energy up to the end
// of window j that is floor(fires C_j) spikes so far; 1e-9 is added so that whole numbers stay
// whole.
//
// Source    Lim & Park 2023, section 4.2; window length: Gescheider et al. 2003.
// Input     perceived waveform, one value per sample at 10 kHz
// Output    counts per 5 ms step, 2 ceil(N / 100) of them
// Left out  refractory periods, noise, adaptation.
// Exact     same input, same counts, on any number of threads and any instruction set.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "model/physiology/neural_coding_params.h"

namespace tact {

inline constexpr std::size_t kWindowSamples = 100;  // 10 ms
inline constexpr std::size_t kStepSamples = 50;     // 5 ms
inline constexpr double kStepS = 0.005;

constexpr std::size_t window_count(std::size_t samples) {
    return (samples + kWindowSamples - 1) / kWindowSamples;
}
constexpr std::size_t step_count(std::size_t samples) { return 2 * window_count(samples); }

// C_j for every 10 ms window: ends at 1; all zero for a silent waveform.
std::vector<double> energy_fractions(std::span<const double> perceived);

// Counts per 5 ms step; at most a million in 10 ms.
std::vector<int> spike_counts(std::span<const double> energy_fractions, double fires,
                              WindowSplit split);

// Sample offsets, within its step, of n evenly spread unit spikes: floor(k 50 / n), k = 0..n-1. A
// neuron fires at most once a sample: a network without any layer may have more than 50, which
// gives one in every sample.
std::vector<std::size_t> spread_spikes(int count);

}  // namespace tact
