#include "model/metrics/spectral_rmse.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "model/common/portable.h"
#include "model/metrics/product_sum.h"

namespace tact {

namespace {

constexpr double kFaintestG = 1e-6;

}  // namespace

std::vector<double> compared_lines(const Spectrum& spectrum, const SpectralRmseParams& params) {
    std::vector<double> lines = spectrum.amplitude_g;
    if (params.scale == SpectrumScale::decibel) {
        for (double& line : lines) line = 20.0 * portable::log10(std::max(line, kFaintestG));
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

double spectral_rmse(const std::vector<double>& x, const std::vector<double>& y,
                     const SpectralRmseParams& params) {
    assert(x.size() == y.size() && "spectra of different lines");
    if (x.empty() || x == y) return 0.0;
    if (params.error == SpectralError::goodness_of_fit) {
        const double scale = std::sqrt(product_sum(x, x) * product_sum(y, y));
        if (scale == 0.0) return 1.0;
        return std::max(0.0, 1.0 - std::abs(product_sum(x, y)) / scale);
    }
    double squares = 0.0;
    for (std::size_t k = 0; k < x.size(); ++k) squares += (x[k] - y[k]) * (x[k] - y[k]);
    if (params.error == SpectralError::rmse) {
        return std::sqrt(squares / static_cast<double>(x.size()));
    }
    const double reference = product_sum(x, x);
    return reference == 0.0 ? 1.0 : std::sqrt(squares / reference);
}

}  // namespace tact
