// Msm: how far apart two spectra are once neighbouring lines that feel alike are put together.
//
//     S[k] = sqrt( mean_{j in W_k} A[j]^2 ),   W_k = { j : |f_j - f_k| <= 0.05 f_k }
//     Msm = sqrt( mean_{1 <= f_k <= 1000 Hz} (S_x[k] - S_y[k])^2 )
//
// The 10 % are a Weber-like width: the paper calls it a differential threshold.
//
// Confidence  [M] structure, [L] form of the window and no normalisation
// Source    Park & Kuchenbecker 2019, as Lim & Park 2023, section 2.3, tell it.
// Input     spectra of two waveforms of one length and rate
// Output    g; 0..sqrt 2 where normalised
// Left out  phase. Where lines lie farther apart than half a window nothing is smoothed.
#pragma once

#include <vector>

#include "model/signal/spectrum.h"

namespace tact {

enum class SubBandMean {
    root_mean_square,  // [ours] power adds
    arithmetic         // mean of A
};

struct SpectralMatchingParams {
    double width = 0.10;  // of W_k, as a share of f_k; 0.20: the reading +-10 %
    double low_hz = 1.0;  // of the band, both ends in it
    double high_hz = 1000.0;
    SubBandMean mean = SubBandMean::root_mean_square;
    bool is_normalised = false;  // by sqrt of the mean of both spectra's mean squares

    bool operator==(const SpectralMatchingParams&) const = default;
};

// S of the lines in the band; windows reach beyond it.
std::vector<double> sub_band_spectrum(const Spectrum& spectrum,
                                      const SpectralMatchingParams& params = {});

// Msm of two such spectra; 0 where there are no lines.
double spectral_matching(const std::vector<double>& x, const std::vector<double>& y,
                         const SpectralMatchingParams& params = {});

}  // namespace tact
