// A vibration in blocks, and each block's spectrum over the threshold of feeling: what ST-SIM and
// SPQI compare.
//
//     P[k] = 20 log10 |X[k]| - T[k] dB,   X the orthonormal cosine transform of a block
//     T[k] = | 62 / log10(6/11)^2 log10(f_k / 550 + 6/11)^2 | - 77 dB,   f_k = k rate / (2L - 1)
//
// T is lowest, -77 dB, at 250 Hz; from the first value above 0 on it is held.
//
// Confidence  [H] for the published code, [M] for the papers' texts; [L] the unit of X
// Source    Hassen & Steinbach 2020; Noll et al. 2022.
// Input     samples in g at a rate
// Output    floor(N / L) blocks, the remainder cut off; of less than L samples one, zero-padded
// Left out  the published code's other transform, a zero-padded Fourier transform.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "model/signal/waveform.h"

namespace tact {

// The rate that f_k are of.
enum class ThresholdRate {
    actual,          // [ours] the waveform's
    published,       // 8 kHz whatever the rate, as the published code has it
    resampled_to_it  // waveforms brought to 8 kHz first: blocks of 64 ms, as published
};

enum class AmplitudeUnit {
    g,  // as it is
    m_per_s2
};

struct PerceptualSpectrumParams {
    std::size_t block_samples = 512;  // L
    ThresholdRate rate = ThresholdRate::actual;
    AmplitudeUnit unit = AmplitudeUnit::g;

    bool operator==(const PerceptualSpectrumParams&) const = default;
};

inline constexpr double kPublishedRateHz = 8000.0;

// Added to sums that are divided by, as published.
inline constexpr double kBlockEpsilon = 2.22e-16;

// T of a block's L lines.
std::vector<double> perceptual_threshold_db(std::size_t block_samples, double rate_hz);

// The orthonormal DCT-II of a block:
// X[k] = s_k sum_n b[n] cos(pi k (2n + 1) / (2L)), s_0 = sqrt(1 / L), else sqrt(2 / L).
std::vector<double> cosine_transform(std::span<const double> block);

struct PerceptualBlocks {
    std::size_t block_samples = 0;
    std::size_t count = 0;
    std::vector<double> samples;   // block by block
    std::vector<double> level_db;  // P, likewise; -infinity where a line is 0
};

PerceptualBlocks perceptual_blocks(const Waveform& waveform,
                                   const PerceptualSpectrumParams& params = {});

}  // namespace tact
