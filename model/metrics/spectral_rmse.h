// How far apart two amplitude spectra are, line by line.
//
//     D = sqrt( 1/K sum_{k in band} (A_x[k] - A_y[k])^2 )
//
// Confidence  [M] formula, [L] window, band and scale: Lim & Park 2023 give none of them
// Source    Romano & Kuchenbecker 2012 (normalised error), Hernandez-Andres et al. 2001 as
//           Culbertson & Kuchenbecker use it (goodness of fit); both from memory.
// Input     spectra of two waveforms of one length and rate
// Output    g where linear, dB where not, or no unit. A lone line off by a gives
//           a / sqrt(K): small numbers are normal.
// Left out  phase, and so shifts in time of periodic signals; windows.
#pragma once

#include <cstddef>
#include <limits>
#include <vector>

#include "model/signal/spectrum.h"

namespace tact {

enum class SpectrumScale {
    linear,  // what sub-band matching generalises; in dB the floors of leakage decide
    decibel  // 20 log10(max(A / 1 g, 1e-6))
};

enum class SpectralError {
    rmse,            // symmetric
    normalised,      // RMS(A_x - A_y) / RMS(A_x), x the reference: Romano & Kuchenbecker 2012
    goodness_of_fit  // 1 - |sum A_x A_y| / sqrt(sum A_x^2 sum A_y^2)
};

struct SpectralRmseParams {
    SpectrumScale scale = SpectrumScale::linear;
    SpectralError error = SpectralError::rmse;
    double low_hz = 0.0;  // of the band, both ends in it
    double high_hz = std::numeric_limits<double>::infinity();
    std::size_t smoothing_lines = 1;  // odd: moving mean, of fewer lines at the ends

    bool operator==(const SpectralRmseParams&) const = default;
};

// The lines of the band, smoothed and on the scale asked for.
std::vector<double> compared_lines(const Spectrum& spectrum, const SpectralRmseParams& params = {});

// D of two such. Silence is 0 from silence and 1 from sound where the error is relative. An empty
// band gives 0.
double spectral_rmse(const std::vector<double>& x, const std::vector<double>& y,
                     const SpectralRmseParams& params = {});

}  // namespace tact
