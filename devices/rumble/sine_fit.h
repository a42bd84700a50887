// One or two sines fitted to a stretch of a signal by weighted least squares.
//
//     sum_i  c_i cos(2 pi f_i t) + s_i sin(2 pi f_i t)
//
// The strongest peak of the weighted spectrum starts the first sine, the strongest peak of what it
// leaves the next; then all are refined together (Gauss-Newton), as each biases the other's peak
// where they are close.
//
// Input     samples with weights: a window, and zero where a sample does not count
// Output    at most two tones, by frequency; share_left: of the weighted energy, that they are not
// Valid     tones within kToneHz. Two that are nearer than kLeastApartHz are taken for one.
// Left out  tones that glide or swell within the stretch.
// Exact     same input, same bits in one build.
#pragma once

#include <cmath>
#include <cstddef>
#include <numbers>
#include <optional>
#include <span>
#include <vector>

#include "model/common/units.h"
#include "model/signal/spectrum.h"

namespace tact {

// Where tones are looked for: from a period and a half under a short window to the highest that any
// actuator here can be asked for.
inline constexpr Range kToneHz{20.0, 1252.57};

// Two tones that are nearer are one, under a window of kLongWindowS. Half the window tells apart
// what is twice as far.
inline constexpr double kLeastApartHz = 12.0;
inline constexpr double kLongWindowS = 0.1;

// A fit that leaves less needs no better one.
inline constexpr double kWellFitted = 0.003;

struct Tone {
    double frequency_hz = 0.0;
    double cosine = 0.0;
    double sine = 0.0;

    double amplitude() const { return std::hypot(cosine, sine); }
    double at(double t_s) const {
        const double angle = 2.0 * std::numbers::pi * frequency_hz * t_s;
        return cosine * std::cos(angle) + sine * std::sin(angle);
    }
};

// A piece of a signal: what of it counts, and how much.
struct Stretch {
    double rate_hz = kModelRateHz;
    double first_s = 0.0;         // time of sample 0, from the middle of the frame
    std::vector<double> samples;  // zero beyond the signal's ends
    std::vector<double> weights;  // Hann; zero where it is silent

    double time_s(std::size_t n) const { return first_s + static_cast<double>(n) / rate_hz; }
};

struct SineFit {
    std::vector<Tone> tones;
    double share_left = 1.0;  // of the weighted energy
};

// Fits sines to a window this long, Hann or nearly so.
SineFit fitted_sines(const Stretch& stretch, double window_s);

// The strongest sine of a stretch, to a few Hz; none in silence.
std::optional<Tone> strongest_tone(const Stretch& stretch);

// The weighted energy of the stretch, and the share of it that some tones leave, 0..1.
double energy_of(const Stretch& stretch);
double share_left_by(const Stretch& stretch, std::span<const Tone> tones);

// Weighted and padded, so that its maximum is near the strongest tone's frequency.
Spectrum weighted_spectrum(const Stretch& stretch);

}  // namespace tact
