#include "model/baseline/spectral_rmse.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <vector>

namespace tact {

namespace {

constexpr double kFaintestG = 1e-6;

// The lines of the band on the scale asked for.
std::vector<double> scaled_lines(const Spectrum& spectrum, const SpectralRmseParams& params) {
    std::vector<double> lines = spectrum.amplitude_g;
    if (params.scale == SpectrumScale::decibel) {
        for (double& line : lines) line = 20.0 * std::log10(std::max(line, kFaintestG));
    }
    const std::size_t reach = params.smoothing_lines / 2;
    std::vector<double> kept;
    for (std::size_t k = 0; k < lines.size(); ++k) {
        const double f_hz = frequency_hz(spectrum, k);
        if (f_hz < params.low_hz || f_hz > params.high_hz) continue;
        const std::size_t begin = k - std::min(k, reach);
        const std::size_t end = std::min(k + reach + 1, lines.size());
        double sum = 0.0;
        for (std::size_t j = begin; j < end; ++j) sum += lines[j];
        kept.push_back(sum / static_cast<double>(end - begin));
    }
    return kept;
}

double product_sum(const std::vector<double>& a, const std::vector<double>& b) {
    double sum = 0.0;
    for (std::size_t k = 0; k < a.size(); ++k) sum += a[k] * b[k];
    return sum;
}

}  // namespace

double spectral_rmse(const Spectrum& x, const Spectrum& y, const SpectralRmseParams& params) {
    assert(x.samples == y.samples && x.rate_hz == y.rate_hz && "spectra of different lines");
    const std::vector<double> a = scaled_lines(x, params);
    const std::vector<double> b = scaled_lines(y, params);
    if (a.empty() || a == b) return 0.0;
    if (params.error == SpectralError::goodness_of_fit) {
        const double scale = std::sqrt(product_sum(a, a) * product_sum(b, b));
        if (scale == 0.0) return 1.0;
        return std::max(0.0, 1.0 - std::abs(product_sum(a, b)) / scale);
    }
    double squares = 0.0;
    for (std::size_t k = 0; k < a.size(); ++k) squares += (a[k] - b[k]) * (a[k] - b[k]);
    if (params.error == SpectralError::rmse) {
        return std::sqrt(squares / static_cast<double>(a.size()));
    }
    const double reference = product_sum(a, a);
    return reference == 0.0 ? 1.0 : std::sqrt(squares / reference);
}

}  // namespace tact
