#include "model/signal/cut_and_fade.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "model/common/portable.h"

namespace tact {

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

}  // namespace tact
