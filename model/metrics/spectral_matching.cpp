#include "model/metrics/spectral_matching.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace tact {

namespace {

// A line at a multiple of its width is in the window, however width k was rounded.
constexpr double kRounding = 1e-9;

double sub_band(const Spectrum& spectrum, std::size_t k, const SpectralMatchingParams& params) {
    const auto& lines = spectrum.amplitude_g;
    const double reach = std::floor(params.width / 2.0 * static_cast<double>(k) + kRounding);
    const auto half = static_cast<std::size_t>(reach);
    const std::size_t begin = k - std::min(k, half);
    const std::size_t end = std::min(k + half + 1, lines.size());
    const auto count = static_cast<double>(end - begin);
    // No running sums: what they leave behind, 1e-16, is 1e-8 after the root.
    double sum = 0.0;
    if (params.mean == SubBandMean::arithmetic) {
        for (std::size_t j = begin; j < end; ++j) sum += lines[j];
        return sum / count;
    }
    for (std::size_t j = begin; j < end; ++j) sum += lines[j] * lines[j];
    return std::sqrt(sum / count);
}

}  // namespace

std::vector<double> sub_band_spectrum(const Spectrum& spectrum,
                                      const SpectralMatchingParams& params) {
    assert(params.width >= 0.0 && "a window has a width");
    std::vector<double> bands;
    for (std::size_t k = 0; k < spectrum.amplitude_g.size(); ++k) {
        const double f_hz = frequency_hz(spectrum, k);
        if (f_hz < params.low_hz || f_hz > params.high_hz) continue;
        bands.push_back(sub_band(spectrum, k, params));
    }
    return bands;
}

double spectral_matching(const std::vector<double>& x, const std::vector<double>& y,
                         const SpectralMatchingParams& params) {
    assert(x.size() == y.size() && "spectra of different lines");
    double apart = 0.0;
    double x_squares = 0.0;
    double y_squares = 0.0;
    for (std::size_t k = 0; k < x.size(); ++k) {
        apart += (x[k] - y[k]) * (x[k] - y[k]);
        x_squares += x[k] * x[k];
        y_squares += y[k] * y[k];
    }
    if (apart == 0.0) return 0.0;
    if (params.is_normalised) return std::sqrt(apart / ((x_squares + y_squares) / 2.0));
    return std::sqrt(apart / static_cast<double>(x.size()));
}

}  // namespace tact
