#include "model/signal/waveform.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <numeric>

#include "model/common/portable.h"

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

double fade_gain(double since_s, double length_s) {
    if (!(since_s < length_s)) return 1.0;
    return 0.5 - 0.5 * portable::cos(std::numbers::pi * since_s / length_s);
}

Waveform with_gain(Waveform waveform, double gain) {
    for (double& sample : waveform.samples_g) sample *= gain;
    return waveform;
}

Waveform part_of(const Waveform& waveform, double begin_s, double end_s) {
    const double whole_s = duration_s(waveform);
    const auto place = [&](double t_s) {
        const std::size_t at = sample_count(std::clamp(t_s, 0.0, whole_s), waveform.rate_hz);
        return static_cast<std::ptrdiff_t>(std::min(at, waveform.samples_g.size()));
    };
    Waveform part{waveform.rate_hz, {}};
    if (!(begin_s < end_s)) return part;
    const auto start = waveform.samples_g.begin();
    part.samples_g.assign(start + place(begin_s), start + place(end_s));
    return part;
}

Waveform faded(Waveform waveform, double fade_in_s, double fade_out_s) {
    const std::size_t samples = waveform.samples_g.size();
    for (std::size_t n = 0; n < samples; ++n) {
        const double since_s = static_cast<double>(n) / waveform.rate_hz;
        const double until_s = static_cast<double>(samples - n) / waveform.rate_hz;
        waveform.samples_g[n] *= fade_gain(since_s, fade_in_s) * fade_gain(until_s, fade_out_s);
    }
    return waveform;
}

double relative_difference(std::span<const double> a, std::span<const double> b) {
    double apart = 0.0;
    double all = 0.0;
    for (std::size_t k = 0; k < std::max(a.size(), b.size()); ++k) {
        const double left = k < a.size() ? a[k] : 0.0;
        const double right = k < b.size() ? b[k] : 0.0;
        apart += std::abs(left - right);
        all += std::abs(left) + std::abs(right);
    }
    return all > 0.0 ? apart / all : 0.0;
}

}  // namespace tact
