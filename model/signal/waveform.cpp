#include "model/signal/waveform.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace tact {

double duration_s(const Waveform& waveform) {
    return static_cast<double>(waveform.samples_g.size()) / waveform.rate_hz;
}

double peak_g(const Waveform& waveform) {
    double peak = 0.0;
    for (const double sample : waveform.samples_g) {
        if (std::isnan(sample)) return sample;
        peak = std::max(peak, std::abs(sample));
    }
    return peak;
}

double rms_g(const Waveform& waveform) {
    if (waveform.samples_g.empty()) return 0.0;
    double energy = 0.0;
    for (const double sample : waveform.samples_g) energy += sample * sample;
    return std::sqrt(energy / static_cast<double>(waveform.samples_g.size()));
}

std::size_t sample_count(double duration_s, double rate_hz) {
    return static_cast<std::size_t>(std::llround(duration_s * rate_hz));
}

Waveform padded(Waveform waveform, std::size_t samples) {
    if (waveform.samples_g.size() < samples) waveform.samples_g.resize(samples, 0.0);
    return waveform;
}

std::vector<double> without_mean(std::span<const double> samples) {
    std::vector<double> result(samples.begin(), samples.end());
    if (result.empty()) return result;
    const double mean =
        std::accumulate(result.begin(), result.end(), 0.0) / static_cast<double>(result.size());
    for (double& sample : result) sample -= mean;
    return result;
}

}  // namespace tact
