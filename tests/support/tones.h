// Plain signals for the worked examples of metrics, at any rate.
#pragma once

#include <cmath>
#include <cstddef>
#include <numbers>

#include "model/signal/waveform.h"

namespace tact {

// amplitude sin(2 pi f n / rate), n = 0 .. samples - 1.
inline Waveform tone(double f_hz, double rate_hz, std::size_t samples, double amplitude_g = 1.0) {
    Waveform waveform{rate_hz, {}};
    for (std::size_t n = 0; n < samples; ++n) {
        const double turns = f_hz * static_cast<double>(n) / rate_hz;
        waveform.samples_g.push_back(amplitude_g * std::sin(2.0 * std::numbers::pi * turns));
    }
    return waveform;
}

// a x + b y, sample by sample.
inline Waveform mixed(double a, const Waveform& x, double b, const Waveform& y) {
    Waveform sum = x;
    for (std::size_t n = 0; n < sum.samples_g.size(); ++n) {
        sum.samples_g[n] = a * x.samples_g[n] + b * y.samples_g[n];
    }
    return sum;
}

inline Waveform product(const Waveform& x, const Waveform& y) {
    Waveform both = x;
    for (std::size_t n = 0; n < both.samples_g.size(); ++n) both.samples_g[n] *= y.samples_g[n];
    return both;
}

}  // namespace tact
