// A voice coil on a spring to be measured: what it does, what theory says of it, what a sensor
// hears.
#pragma once

#include <cmath>
#include <complex>
#include <numbers>
#include <vector>

#include "devices/calibration/calibration.h"
#include "devices/calibration/calibration_run.h"
#include "model/common/random.h"

namespace tact {

namespace coil {

inline constexpr double kTau = 2.0 * std::numbers::pi;

// A voice coil on a spring: a resonance with this gain at 0 Hz, as a recurrence of the bilinear
// transform. `gain_at` is what theory says of the same recurrence.
struct Coil {
    double resonance_hz = 80.0;
    double q = 3.0;
    double gain_g = 0.5;
    double cubic = 0.0;  // of the output: distortion

    struct Coefficients {
        double b0, b1, b2, a1, a2;
    };
    Coefficients coefficients() const {
        // H(s) = gain s^2 / (s^2 + s w/q + w^2): acceleration of a mass on a spring.
        const double w = 2.0 * std::tan(kTau * resonance_hz / kModelRateHz / 2.0);
        const double a0 = 4.0 + 2.0 * w / q + w * w;
        return {4.0 * gain_g / a0, -8.0 * gain_g / a0, 4.0 * gain_g / a0, (2.0 * w * w - 8.0) / a0,
                (4.0 - 2.0 * w / q + w * w) / a0};
    }
    std::vector<double> moved(const std::vector<double>& drive) const {
        const Coefficients c = coefficients();
        std::vector<double> out(drive.size());
        double x1 = 0, x2 = 0, y1 = 0, y2 = 0;
        for (std::size_t n = 0; n < drive.size(); ++n) {
            const double y = c.b0 * drive[n] + c.b1 * x1 + c.b2 * x2 - c.a1 * y1 - c.a2 * y2;
            x2 = x1;
            x1 = drive[n];
            y2 = y1;
            y1 = y;
            out[n] = y + cubic * y * y * y;
        }
        return out;
    }
    double gain_at(double f_hz) const {
        const Coefficients c = coefficients();
        const std::complex<double> z = std::polar(1.0, -kTau * f_hz / kModelRateHz);
        return std::abs((c.b0 + c.b1 * z + c.b2 * z * z) / (1.0 + c.a1 * z + c.a2 * z * z));
    }
};

// A recording that begins `before` samples earlier and has a noisy sensor.
inline Waveform recorded(const Coil& coil, const CalibrationPlan& plan, std::size_t before,
                         double noise_g) {
    std::vector<double> drive(before, 0.0);
    drive.insert(drive.end(), plan.drive.samples.begin(), plan.drive.samples.end());
    drive.resize(drive.size() + 3000, 0.0);
    Waveform waveform{kModelRateHz, coil.moved(drive)};
    RandomStream random{7};
    for (double& sample : waveform.samples_g) sample += noise_g * next_normal(random);
    return waveform;
}

// A response of three points.
inline Calibration table() {
    Calibration calibration;
    calibration.points = {{50.0, 0.4}, {100.0, 1.6}, {200.0, 0.8}};
    return calibration;
}

}  // namespace coil

}  // namespace tact
