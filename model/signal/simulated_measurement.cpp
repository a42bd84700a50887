#include "model/signal/simulated_measurement.h"

#include <cassert>
#include <cmath>
#include <complex>
#include <numbers>

#include "model/common/portable.h"
#include "model/common/random.h"
#include "model/signal/butterworth.h"
#include "model/signal/spectrum.h"

namespace tact {

namespace {

constexpr double kRingDownS = 0.1;

Section resonance(const ActuatorParams& params, double rate_hz) {
    const double k = portable::tan(std::numbers::pi * params.resonance_hz / rate_hz);
    const double scale = 1.0 / (1.0 + k / params.q + k * k);
    const double b = params.gain * scale;
    return {b, -2.0 * b, b, 2.0 * (k * k - 1.0) * scale, (1.0 - k / params.q + k * k) * scale};
}

}  // namespace

Waveform simulated_measurement(const Waveform& drive, const ActuatorParams& params) {
    assert(params.resonance_hz < 0.5 * drive.rate_hz && params.q > 0.0);
    std::vector<double> delayed(sample_count(params.onset_s, drive.rate_hz), 0.0);
    delayed.insert(delayed.end(), drive.samples_g.begin(), drive.samples_g.end());
    delayed.resize(delayed.size() + sample_count(kRingDownS, drive.rate_hz), 0.0);
    const Section section = resonance(params, drive.rate_hz);
    Waveform result{drive.rate_hz, filtered({&section, 1}, delayed)};
    RandomStream noise{random_bits(params.seed, 0), 0};
    for (double& sample : result.samples_g) sample += params.noise_g * next_normal(noise);
    return result;
}

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
