// R7: neural coding with the spike distance of the field in the place of its root mean square.
//
// Each spike becomes an exponential tail, f(t) = sum_i w_i exp(-(t - t_i) / tau) for t > t_i, and
//
//     D^2 = 1/tau integral (f_x - f_y)^2 dt
//
// so that spikes a little apart are nearly one, where the root mean square knows only coincidence.
//
// Confidence  [H] ours, not from the paper: what the choice of the spike distance does
// Source    van Rossum 2001; spikes of Lim & Park 2023, section 4.
// Input     the central spikes of two patterns of one length
// Output    no unit; a lone spike of weight 1 has sqrt(1/2) from silence
// Exact     the integral in closed form, tail included
#pragma once

#include <vector>

#include "model/physiology/neural_coding.h"

namespace tact {

enum class SpikeLines {
    together,   // tails of the brain waveform, the channels' weighted sum
    one_by_one  // a distance of each channel, weighted, and the root of their squares
};

struct VanRossumParams {
    double tau_s = 0.010;
    SpikeLines lines = SpikeLines::together;

    bool operator==(const VanRossumParams&) const = default;
};

// f at the samples: one line, or one for each channel.
struct SpikeTails {
    std::vector<std::vector<double>> lines;
};

SpikeTails spike_tails(const NeuralCode& code, const PerReceptor<double>& channel_weight,
                       const VanRossumParams& params = {});

double van_rossum(const SpikeTails& x, const SpikeTails& y, const VanRossumParams& params = {});

}  // namespace tact
