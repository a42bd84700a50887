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

// Cutting a waveform to what is wanted of it: gain, trim, fades.
//
// Fades are halves of a raised cosine: (1 - cos(pi t / T)) / 2 from the first sample on, the same
// backwards to the end.
//
// Output    a waveform of the same rate
// Valid     any numbers: times are cut to the waveform; fades that meet are multiplied

Waveform with_gain(Waveform waveform, double gain);

// The part from one time up to another; none of it where they do not enclose any.
Waveform part_of(const Waveform& waveform, double begin_s, double end_s);

// So long after the beginning of a fade: from 0 to 1, and 1 behind it.
double fade_gain(double since_s, double length_s);

// 0 at the first sample and one beyond the last; 1 from `fade_in_s` to `fade_out_s` before the end.
Waveform faded(Waveform waveform, double fade_in_s, double fade_out_s);

// How much of two signals they do not have in common: 0 the same, 1 nothing.
//
//     sum |a - b| / sum (|a| + |b|)
//
// Source    ours, not the paper's; for signals >= 0 it is the dissimilarity of Bray & Curtis 1957.
// Left out  shifts: a signal and the same one later differ.

// Where one signal is shorter, zeros follow. Two silent signals are the same: 0.
double relative_difference(std::span<const double> a, std::span<const double> b);

}  // namespace tact
