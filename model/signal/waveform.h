// A vibration as samples: acceleration in g at a constant rate.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "model/common/units.h"

namespace tact {

struct Waveform {
    double rate_hz = kModelRateHz;
    std::vector<double> samples_g;

    bool operator==(const Waveform&) const = default;
};

// Larger accelerations are refused: no skin sees them, and their squares must stay finite.
inline constexpr double kMaxSampleG = 1e6;

double duration_s(const Waveform& waveform);

// Largest absolute value and root of the mean square, in g; 0 for an empty waveform, NaN where a
// sample is NaN.
double peak_g(const Waveform& waveform);
double rms_g(const Waveform& waveform);

// Samples that a duration takes at a rate, rounded to the nearest.
std::size_t sample_count(double duration_s, double rate_hz);

// The same waveform with zeros appended up to `samples` (never shortened).
Waveform padded(Waveform waveform, std::size_t samples);

// The samples minus their mean (a constant offset is no vibration).
std::vector<double> without_mean(std::span<const double> samples);

}  // namespace tact
