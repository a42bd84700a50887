// ST-SIM: how similar a vibration is to a reference, in spectrum over threshold and in shape.
//
//     S-SIM  = mean_blocks( sum_k S_r S_d / (sum_k S_r^2 + eps) ),   S = Phi(P / 12 dB)
//     T-SIM  = mean_blocks( sum_n u_r u_d / (sum_n u_r^2 + eps) ),   u = (b - mean b) / (sd b +
//     eps) ST-SIM = T-SIM^(2/3) S-SIM^(1/3),   D = 1 - ST-SIM
//
// For a negative T-SIM the published code gives a complex number. Here it keeps its sign through
// the power, sign(T) |T|^(2/3): the order of the published value's real part, and no new ties.
//
// Confidence  [H] for the published code, [M] for the paper's text; [L] negative T-SIM, the unit
// Source    Hassen & Steinbach 2020.
// Input     blocks of two vibrations, as many of each
// Output    about -1..1.05, more than 1 from weak references; not symmetric; 1 for equal blocks;
//           0 where one of the two is silent
#pragma once

#include <vector>

#include "model/metrics/perceptual_spectrum.h"

namespace tact {

enum class NegativeShape {
    signed_power,  // [ours]
    clamped        // T-SIM is 0 there
};

// A block in which both are silent has nothing in common by the formula.
enum class SharedSilence {
    counts_as_unlike,  // as published: rhythms are penalised for the gaps they share
    left_out           // of both means
};

struct StSimParams {
    PerceptualSpectrumParams spectrum;
    double shape_weight = 2.0 / 3.0;  // eta
    double spread_db = 12.0;          // sigma of Phi
    NegativeShape negative_shape = NegativeShape::signed_power;
    SharedSilence shared_silence = SharedSilence::counts_as_unlike;

    bool operator==(const StSimParams&) const = default;
};

// What is compared, block by block, and the sums that each comparison needs.
struct StSimBlocks {
    std::size_t block_samples = 0;
    std::vector<double> support;         // S
    std::vector<double> shape;           // u; 0 in constant blocks
    std::vector<double> support_energy;  // sum S^2 of each block
    std::vector<double> shape_energy;    // sum u^2
    std::vector<bool> is_silent;         // by block
};

StSimBlocks st_sim_blocks(const Waveform& waveform, const StSimParams& params = {});

struct StSim {
    double spectral = 0.0;    // S-SIM
    double temporal = 0.0;    // T-SIM
    double similarity = 0.0;  // ST-SIM
};

StSim st_sim(const StSimBlocks& reference, const StSimBlocks& other,
             const StSimParams& params = {});

}  // namespace tact
