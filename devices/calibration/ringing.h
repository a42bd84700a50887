// A sharp resonance, worked out from the signal that it rang at: where an actuator rings for longer
// than a tone or a sweep stays with it, what was measured there is not its strength.
//
// A mass on a spring, S(f) = g / sqrt((1 - u)^2 + u / Q^2) with u = (f0 / f)^2, is driven by the
// plan's own signal, and measured by the same fits as the recording; f0, Q and g are those whose
// strengths are nearest to the measured ones, in the mean square of their logarithms.
//
// Source    Gauss-Newton from the best of a grid, which is by S(f) alone
// Input     strengths measured within half an octave of a peak: five of them at least
// Output    none where no peak is sharp, or where no such resonance is within 0.3 dB of all points
// Left out  two resonances within half an octave.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "devices/calibration/calibration_run.h"

namespace tact {

struct Resonance {
    double f0_hz = 0.0;
    double q = 0.0;
    double g = 0.0;       // far above f0
    double low_hz = 0.0;  // between these it is known
    double high_hz = 0.0;
    double off_db = 0.0;        // the farthest of the points from it
    double corrected_db = 0.0;  // the most that a point was off for its ringing

    bool operator==(const Resonance&) const = default;
};

double strength_g(const Resonance& resonance, double f_hz);

// What each tone of the plan would be measured to have, per full scale.
std::vector<double> rung_g(const CalibrationPlan& plan, const std::vector<CalibrationTone>& tones,
                           const Resonance& resonance);

// `tones`: those by which the points were measured, frequencies rising. Corrects the points.
std::vector<Resonance> sharp_resonances(const CalibrationPlan& plan,
                                        const std::vector<CalibrationTone>& tones,
                                        std::vector<ResponsePoint>& points);

// A tone of a calibration signal in a recording: amplitude, distortion and noise by least squares
// (calibration_run.h).

struct ToneFit {
    double amplitude_g = 0.0;
    double thd = 0.0;
    double snr_db = 0.0;
    double standard_error = 0.0;
};

// Fit to a recording that begins the plan at `start`.
ToneFit fit_of(const CalibrationPlan& plan, const CalibrationTone& tone,
               std::span<const double> samples, std::size_t start);

}  // namespace tact
