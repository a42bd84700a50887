#include "devices/device/protection.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>

#include "model/signal/spectrum.h"
#include "model/signal/waveform.h"

namespace tact {

namespace {

constexpr double kLowestHz = 16.0;        // a burst of 20 Hz reaches down to there
constexpr double kNothingBelowHz = 12.0;  // a soft edge rings less
constexpr double kEdgeRampS = 0.005;
constexpr double kLittleShare = 0.02;  // of the energy

double energy(const std::vector<double>& samples) {
    double sum = 0.0;
    for (const double sample : samples) sum += sample * sample;
    return sum;
}

double passed_share(double f_hz) {
    if (f_hz >= kLowestHz) return 1.0;
    if (f_hz <= kNothingBelowHz) return 0.0;
    const double share = (f_hz - kNothingBelowHz) / (kLowestHz - kNothingBelowHz);
    return 0.5 - 0.5 * std::cos(std::numbers::pi * share);
}

// The share of its energy that went.
double take_slow_motion(Drive& drive) {
    const double before = energy(drive.samples);
    if (before <= 0.0) return 0.0;
    std::vector<double> high = zero_phase_filtered(drive.samples, drive.rate_hz, passed_share);
    double lost = 0.0;
    for (std::size_t n = 0; n < high.size(); ++n) {
        lost += (drive.samples[n] - high[n]) * (drive.samples[n] - high[n]);
    }
    if (lost < kLittleShare * before) return 0.0;
    drive.samples = std::move(high);
    return std::min(1.0, lost / before);
}

void soften_ends(Drive& drive) {
    const std::size_t count = drive.samples.size();
    const std::size_t rise = std::min(sample_count(kEdgeRampS, drive.rate_hz), count / 2);
    for (std::size_t n = 0; n < rise; ++n) {
        const double share = (static_cast<double>(n) + 0.5) / static_cast<double>(rise);
        const double gain = 0.5 - 0.5 * std::cos(std::numbers::pi * share);
        drive.samples[n] *= gain;
        drive.samples[count - 1 - n] *= gain;
    }
}

std::string words(const char* format, double value) {
    char text[160];
    std::snprintf(text, sizeof text, format, value);
    return text;
}

}  // namespace

ProtectedDrive protected_drive(const Drive& drive, bool loop, bool is_on, double longest_s) {
    ProtectedDrive made{drive, {}};
    if (!is_on) return made;
    for (double& sample : made.drive.samples) {
        if (!std::isfinite(sample)) sample = 0.0;
    }
    const double lost = take_slow_motion(made.drive);
    if (!loop) soften_ends(made.drive);
    made.drive.longest_s = std::min(made.drive.longest_s, longest_s);
    if (lost > 0.0) {
        made.remark = words(
            "loses what is slower than 16 Hz, %.0f %% of its energy: an actuator without a "
            "calibration might not bear it",
            100.0 * lost);
    }
    const double length_s = static_cast<double>(drive.samples.size()) / drive.rate_hz;
    if (!loop && length_s > longest_s) {
        made.remark +=
            std::string(made.remark.empty() ? "" : ", and ") +
            words("ends after %g s, as nobody knows how warm the actuator gets", longest_s);
    }
    return made;
}

}  // namespace tact
