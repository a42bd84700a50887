// How far two patterns are apart in strength, by another way than the program's own judge of
// exports (model/export/envelope_error.h): the energy of their waveforms under a window of 30 ms.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include "model/pattern/pattern.h"

namespace tact::strength_off {

// What the two ways may differ by, beside the 0.1 dB that nobody is told of.
inline constexpr double kOtherWayDb = 0.25;

// The energy around a time, under a Hann window, as the amplitude of a steady tone.
inline double strength_g(const Waveform& waveform, double t_s) {
    constexpr double kHalfS = 0.015;
    double sum = 0.0;
    double weights = 0.0;
    for (double since_s = -kHalfS; since_s <= kHalfS; since_s += 1.0 / kModelRateHz) {
        const double weight = 0.5 + 0.5 * std::cos(std::numbers::pi * since_s / kHalfS);
        const auto n = std::lround((t_s + since_s) * kModelRateHz);
        weights += weight;
        if (n < 0 || n >= static_cast<long>(waveform.samples_g.size())) continue;
        const double g = waveform.samples_g[static_cast<std::size_t>(n)];
        sum += weight * g * g;
    }
    return std::sqrt(2.0 * sum / weights);
}

// How far the strength of what came back is from any that was meant within 1 ms, where what was
// meant is well above threshold.
inline double largest_db(const Waveform& asked, const Waveform& got) {
    constexpr double kFelt = 0.1;
    const double duration_s = static_cast<double>(asked.samples_g.size()) / kModelRateHz;
    double worst_db = 0.0;
    for (double t_s = 0.0; t_s < duration_s; t_s += 0.007) {
        const double got_db = 20.0 * std::log10(std::max(strength_g(got, t_s), 1e-9));
        double low_db = 1e9;
        double high_db = -1e9;
        for (const double shift_s : {-0.001, -0.0005, 0.0, 0.0005, 0.001}) {
            const double db = 20.0 * std::log10(std::max(strength_g(asked, t_s + shift_s), 1e-9));
            low_db = std::min(low_db, db);
            high_db = std::max(high_db, db);
        }
        if (high_db < 20.0 * std::log10(kFelt)) continue;
        worst_db = std::max({worst_db, low_db - got_db, got_db - high_db});
    }
    return worst_db;
}

inline double largest_db(const Pattern& meant, const Pattern& back) {
    return largest_db(render(meant), render(back));
}

}  // namespace tact::strength_off
