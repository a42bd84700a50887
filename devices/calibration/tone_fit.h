// A tone of a calibration signal in a recording: amplitude, distortion and noise by least squares
// (calibration_run.h).
#pragma once

#include <cstddef>
#include <span>

#include "devices/calibration/calibration_run.h"

namespace tact {

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
