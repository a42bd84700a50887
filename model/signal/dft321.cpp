#include "model/signal/dft321.h"

#include <cassert>
#include <cmath>
#include <complex>

#include "model/signal/spectrum.h"

namespace tact {

std::vector<double> dft321(std::span<const std::vector<double>> axes) {
    if (axes.empty()) return {};
    const std::size_t samples = axes.front().size();
    std::vector<std::complex<double>> sum(samples == 0 ? 0 : samples / 2 + 1);
    std::vector<double> energy(sum.size(), 0.0);
    for (const std::vector<double>& axis : axes) {
        assert(axis.size() == samples && "axes of several lengths");
        const std::vector<std::complex<double>> half = half_spectrum(axis);
        for (std::size_t k = 0; k < half.size(); ++k) {
            sum[k] += half[k];
            energy[k] += std::norm(half[k]);
        }
    }
    for (std::size_t k = 0; k < sum.size(); ++k) {
        const double magnitude = std::abs(sum[k]);
        sum[k] = magnitude > 0.0 ? sum[k] * (std::sqrt(energy[k]) / magnitude)
                                 : std::complex<double>(std::sqrt(energy[k]));
    }
    return samples_of(sum, samples);
}

}  // namespace tact
