#include "devices/device/protection.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

#include "model/signal/spectrum.h"
#include "model/signal/waveform.h"
#include "model/text/numbers.h"

namespace tact {

namespace {

constexpr double kWholeFromHz = 16.0;    // a burst of 20 Hz reaches down to there
constexpr double kNothingBelowHz = 7.0;  // 1/4 at 10 Hz
constexpr double kEdgeRampS = 0.005;
constexpr double kRingS = 0.1;   // of the filter, at either end of ...
constexpr double kShortS = 0.3;  // ... a shorter drive; what a longer one gives back is 1 % at most
// Share of the energy: what a sudden start alone loses is not worth a word.
constexpr double kToldShare = 0.005;

double energy(const std::vector<double>& samples) {
    double sum = 0.0;
    for (const double sample : samples) sum += sample * sample;
    return sum;
}

double passed_share(double f_hz) {
    if (f_hz >= kWholeFromHz) return 1.0;
    if (f_hz <= kNothingBelowHz) return 0.0;
    const double share = (f_hz - kNothingBelowHz) / (kWholeFromHz - kNothingBelowHz);
    return 0.5 - 0.5 * std::cos(std::numbers::pi * share);
}

// An endless repetition has no ends that the filter could ring at.
std::vector<double> repeated_high_passed(const Drive& drive) {
    std::vector<std::complex<double>> half = half_spectrum(drive.samples);
    const auto length_s = static_cast<double>(drive.samples.size()) / drive.rate_hz;
    for (std::size_t k = 0; k < half.size(); ++k) {
        half[k] *= passed_share(static_cast<double>(k) / length_s);
    }
    return samples_of(half, drive.samples.size());
}

// Adds silence at both ends, where the filter rings.
void widen(Drive& drive) {
    const std::size_t ring = sample_count(kRingS, drive.rate_hz);
    drive.samples.insert(drive.samples.begin(), ring, 0.0);
    drive.samples.insert(drive.samples.end(), ring, 0.0);
    drive.lead_s += static_cast<double>(ring) / drive.rate_hz;
    drive.tail_s += static_cast<double>(ring) / drive.rate_hz;
}

std::vector<double> high_passed(const Drive& drive, bool loop) {
    return loop ? repeated_high_passed(drive)
                : zero_phase_filtered(drive.samples, drive.rate_hz, passed_share);
}

double energy_apart(const std::vector<double>& a, const std::vector<double>& b) {
    double sum = 0.0;
    for (std::size_t n = 0; n < a.size(); ++n) sum += (a[n] - b[n]) * (a[n] - b[n]);
    return sum;
}

// The share of its energy that went. Cut to a short drive's own length, the filter's ring would
// give the slow part back with the cut.
double take_slow_motion(Drive& drive, bool loop) {
    const double before = energy(drive.samples);
    if (before <= 0.0) return 0.0;
    std::vector<double> high = high_passed(drive, loop);
    double lost = energy_apart(drive.samples, high);
    const double length_s = static_cast<double>(drive.samples.size()) / drive.rate_hz;
    if (!loop && length_s < kShortS && lost > kToldShare * before) {
        widen(drive);
        high = high_passed(drive, loop);
        lost = energy_apart(drive.samples, high);
    }
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

}  // namespace

ProtectedDrive protected_drive(const Drive& drive, bool loop, bool is_on,
                               std::optional<double> asked_s) {
    ProtectedDrive made{drive, {}};
    if (!is_on) {
        made.drive.longest_s = std::min(drive.longest_s, asked_s.value_or(drive.longest_s));
        return made;
    }
    const double longest_s = asked_s.value_or(kLongestOnEndS);
    for (double& sample : made.drive.samples) {
        if (!std::isfinite(sample)) sample = 0.0;
    }
    const double lost = take_slow_motion(made.drive, loop);
    if (!loop) soften_ends(made.drive);
    made.drive.longest_s = std::min(made.drive.longest_s, longest_s);
    made.drive.rest_after_s = std::max(kLongestOnEndS, longest_s);
    if (lost > kToldShare) {
        made.remark = "loses what is slower than 16 Hz, " + percent(lost) +
                      " of its energy: an actuator without a calibration might not bear it";
    }
    const double length_s = static_cast<double>(drive.samples.size()) / drive.rate_hz;
    if (!loop && length_s > longest_s) {
        made.remark += std::string(made.remark.empty() ? "" : ", and ") + "ends after " +
                       significant_digits(longest_s, 6) +
                       " s, as nobody knows how warm the actuator gets";
    }
    return made;
}

}  // namespace tact
