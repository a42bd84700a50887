// SPQI: how well a vibration passes for a reference, by the power over threshold that differs.
//
//     Q = 10^(P/10),   E = 10 log10( sum_k |Q_r - Q_d| / (sum_k Q_r + eps) ) dB in each block
//     SPQI = mean_blocks( (1 - tanh(0.3 E + 2)) / 2 ),   D = 1 - SPQI
//
// Unlike vibrations score 0.02 to 1e-10, so that 1 - SPQI crowds at 1. Ranks are made of SPQI
// itself (values_to_rank in model/evaluation/metric.h), and the mean error in dB is offered as a
// distance.
//
// Confidence  [H]
// Source    Noll et al. 2022.
// Input     blocks of two vibrations, as many of each
// Output    0..1, not symmetric: strong after weak scores less than weak after strong. 1 for equal
//           blocks, blocks silent in both, and x against -x; next to 0 from a silent reference
// Left out  phase; nothing changes when both are scaled alike.
#pragma once

#include <vector>

#include "model/metrics/perceptual_spectrum.h"

namespace tact {

enum class SpqiDistance {
    score,    // 1 - SPQI, 0..1
    error_db  // [ours] 60 dB + mean_blocks(E within +-60 dB), 0..120 dB
};

struct SpqiParams {
    PerceptualSpectrumParams spectrum;
    double steepness_per_db = 0.3;  // eta
    double threshold = -2.0;
    SpqiDistance distance = SpqiDistance::score;

    bool operator==(const SpqiParams&) const = default;
};

struct SpqiBlocks {
    std::size_t block_samples = 0;
    std::vector<double> power;        // Q, block by block
    std::vector<double> block_power;  // sum of Q of each block
};

SpqiBlocks spqi_blocks(const Waveform& waveform, const SpqiParams& params = {});

// E of every block; -infinity where both are equal.
std::vector<double> spqi_errors_db(const SpqiBlocks& reference, const SpqiBlocks& other);

double spqi(const SpqiBlocks& reference, const SpqiBlocks& other, const SpqiParams& params = {});

// One way, in what params ask for.
double spqi_distance(const SpqiBlocks& reference, const SpqiBlocks& other,
                     const SpqiParams& params = {});

}  // namespace tact
