#include "devices/calibration/calibration.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>

#include "devices/device/protection.h"
#include "model/common/units.h"
#include "model/signal/spectrum.h"
#include "model/text/numbers.h"

namespace tact {

namespace {

constexpr double kReachOctaves = 1.0 / 3.0;  // beyond the table that is still trusted
constexpr double kEdgeOctaves = 1.0 / 6.0;   // of it, until nothing is sent
constexpr double kLargestBoost = 10.0;       // over the strongest point: 20 dB
constexpr double kEndRampS = 0.005;          // of a pattern that does not end at rest ...
constexpr double kRestShare = 0.02;          // ... of its peak

double octaves_outside(const Calibration& calibration, double frequency_hz) {
    const double below = std::log2(calibration.points.front().frequency_hz / frequency_hz);
    const double above = std::log2(frequency_hz / calibration.points.back().frequency_hz);
    return std::max({0.0, below, above});
}

// Below the table S may keep rising, as above a resonance: it is taken to rise as it does between
// the lowest two, so that nothing is driven harder there than the actuator's own slope allows.
double below_table_g(const std::vector<ResponsePoint>& points, double frequency_hz) {
    const double lowest_g = points.front().g_per_full_scale;
    if (points.size() < 2 || points[1].g_per_full_scale >= lowest_g) return lowest_g;
    const double slope = std::log(points[1].g_per_full_scale / lowest_g) /
                         std::log(points[1].frequency_hz / points[0].frequency_hz);
    return lowest_g * std::pow(frequency_hz / points[0].frequency_hz, slope);
}

// log S between the points; the nearest one's above them, and at least that below.
double interpolated_g(const Calibration& calibration, double frequency_hz) {
    const auto& points = calibration.points;
    const auto above =
        std::ranges::lower_bound(points, frequency_hz, {}, &ResponsePoint::frequency_hz);
    if (above == points.begin()) {
        return frequency_hz > 0.0 ? below_table_g(points, frequency_hz)
                                  : points.front().g_per_full_scale;
    }
    if (above == points.end()) return points.back().g_per_full_scale;
    const ResponsePoint& low = *(above - 1);
    const double share = std::log(frequency_hz / low.frequency_hz) /
                         std::log(above->frequency_hz / low.frequency_hz);
    return low.g_per_full_scale * std::pow(above->g_per_full_scale / low.g_per_full_scale, share);
}

// Between the known points around those that are not known; to the table's end and beyond, where
// none follows.
struct Gap {
    double low_hz = 0.0;
    double high_hz = std::numeric_limits<double>::infinity();
};

std::vector<Gap> gaps_of(const Calibration& calibration) {
    std::vector<Gap> gaps;
    const auto& points = calibration.points;
    for (std::size_t k = 0; k < points.size(); ++k) {
        if (!points[k].unknown) continue;
        Gap gap;
        if (k > 0) gap.low_hz = points[k - 1].frequency_hz;
        while (k < points.size() && points[k].unknown) ++k;
        if (k < points.size()) gap.high_hz = points[k].frequency_hz;
        gaps.push_back(gap);
    }
    return gaps;
}

double octaves_from(const Gap& gap, double frequency_hz) {
    return std::max(
        {0.0, std::log2(gap.low_hz / frequency_hz), std::log2(frequency_hz / gap.high_hz)});
}

// 1 within the table, 0 beyond its reach and where it is not known.
double edge(const Calibration& calibration, const std::vector<Gap>& gaps, double frequency_hz) {
    if (frequency_hz <= 0.0) return 0.0;
    double inside = kReachOctaves - octaves_outside(calibration, frequency_hz);
    for (const Gap& gap : gaps) inside = std::min(inside, octaves_from(gap, frequency_hz));
    const double soft = inside / kEdgeOctaves;
    if (soft >= 1.0) return 1.0;
    return soft <= 0.0 ? 0.0 : 0.5 - 0.5 * std::cos(std::numbers::pi * soft);
}

double strongest_g(const Calibration& calibration) {
    return std::ranges::max_element(calibration.points, {}, &ResponsePoint::g_per_full_scale)
        ->g_per_full_scale;
}

double largest_of(const std::vector<double>& samples) {
    double largest = 0.0;
    for (const double sample : samples) largest = std::max(largest, std::abs(sample));
    return largest;
}

// Root of the mean square of the second that has most.
double loudest_second(const Drive& drive) {
    const auto window = std::max<std::size_t>(1, static_cast<std::size_t>(drive.rate_hz));
    double sum = 0.0;
    double most = 0.0;
    for (std::size_t n = 0; n < drive.samples.size(); ++n) {
        sum += drive.samples[n] * drive.samples[n];
        if (n >= window) sum -= drive.samples[n - window] * drive.samples[n - window];
        most = std::max(most, sum);
    }
    return std::sqrt(most / static_cast<double>(window));
}

// ... of its endless repetition: whole passes, and the rest of a second where that has most.
double loudest_second_of_loop(const Drive& drive) {
    const auto window = std::max<std::size_t>(1, static_cast<std::size_t>(drive.rate_hz));
    const std::size_t length = drive.samples.size();
    if (length == 0) return 0.0;
    const auto square = [&](std::size_t n) {
        const double sample = drive.samples[n % length];
        return sample * sample;
    };
    const std::size_t rest = window % length;
    double pass = 0.0;
    for (std::size_t n = 0; n < length; ++n) pass += square(n);
    double sum = 0.0;
    for (std::size_t n = 0; n < rest; ++n) sum += square(n);
    double most = sum;
    for (std::size_t n = 0; n < length; ++n) {
        sum += square(n + rest) - square(n);
        most = std::max(most, sum);
    }
    const double whole = static_cast<double>(window / length) * pass;
    return std::sqrt(std::max(0.0, whole + most) / static_cast<double>(window));
}

// The slowest motion that a table has a strength for.
double slowest_hz(const Calibration& calibration) {
    return std::min(kLowestMotionHz,
                    calibration.points.front().frequency_hz * std::exp2(-kReachOctaves));
}

// Twice integrated: a / (2 pi f)^2.
double displaced_mm_per_g(double f_hz, double lowest_hz) {
    return f_hz < lowest_hz ? 0.0 : 1e-3 * displacement_um(1.0, f_hz);
}

double excursion_of_pass_mm(const Drive& drive, const Calibration& calibration) {
    return peak_displacement_mm({drive.rate_hz, acceleration_g(drive, calibration)},
                                slowest_hz(calibration));
}

// The spectrum of an endless repetition has lines at whole multiples of one per pass, only there.
double excursion_of_loop_mm(const Drive& drive, const Calibration& calibration) {
    if (drive.samples.empty()) return 0.0;
    std::vector<std::complex<double>> half = half_spectrum(drive.samples);
    const double length_s = static_cast<double>(drive.samples.size()) / drive.rate_hz;
    const double lowest_hz = slowest_hz(calibration);
    for (std::size_t k = 0; k < half.size(); ++k) {
        const double f_hz = static_cast<double>(k) / length_s;
        half[k] *=
            response_g(calibration, f_hz).value_or(0.0) * displaced_mm_per_g(f_hz, lowest_hz);
    }
    return largest_of(samples_of(half, drive.samples.size()));
}

// Below the reach of a table an actuator is taken to be as strong as at its end: nothing is sent
// there but what a sudden end or start spreads.
double pushed_g(const Calibration& calibration, double f_hz, double reach_hz) {
    return interpolated_g(calibration, std::max(f_hz, reach_hz));
}

Travel travel_by(const Drive& drive, const Calibration& calibration, bool loop) {
    const double reach_hz = calibration.points.front().frequency_hz * std::exp2(-kReachOctaves);
    const auto made = [&](std::span<const double> acceleration_g) {
        return travel_of(acceleration_g, drive.rate_hz, reach_hz, calibration.excursion_limit_mm,
                         loop);
    };
    if (!loop || drive.samples.empty()) {
        return made(zero_phase_filtered(drive.samples, drive.rate_hz, [&](double f_hz) {
            return pushed_g(calibration, f_hz, reach_hz);
        }));
    }
    std::vector<std::complex<double>> half = half_spectrum(drive.samples);
    const double length_s = static_cast<double>(drive.samples.size()) / drive.rate_hz;
    for (std::size_t k = 0; k < half.size(); ++k) {
        half[k] *= pushed_g(calibration, static_cast<double>(k) / length_s, reach_hz);
    }
    return made(samples_of(half, drive.samples.size()));
}

// An end that is not at rest would be a blow: where the next sample would be, by the last two.
void soften_end(std::vector<double>& samples, double rate_hz) {
    const std::size_t count = samples.size();
    if (count < 2) return;
    const double next = 2.0 * samples[count - 1] - samples[count - 2];
    if (std::abs(next) <= kRestShare * largest_of(samples)) return;
    const std::size_t fall = std::min(sample_count(kEndRampS, rate_hz), count / 2);
    for (std::size_t n = 0; n < fall; ++n) {
        const double share = (static_cast<double>(n) + 0.5) / static_cast<double>(fall);
        samples[count - 1 - n] *= 0.5 - 0.5 * std::cos(std::numbers::pi * share);
    }
}

// The share of the intended energy that the actuator will not give.
double share_lost(const Waveform& waveform, const Calibration& calibration) {
    const Spectrum spectrum = amplitude_spectrum(waveform.samples_g, waveform.rate_hz);
    const double floor_g = strongest_g(calibration) / kLargestBoost;
    const std::vector<Gap> gaps = gaps_of(calibration);
    double meant = 0.0;
    double lost = 0.0;
    for (std::size_t k = 1; k < spectrum.amplitude_g.size(); ++k) {
        const double f_hz = frequency_hz(spectrum, k);
        const double square = spectrum.amplitude_g[k] * spectrum.amplitude_g[k];
        const double g = interpolated_g(calibration, f_hz);
        const double given = edge(calibration, gaps, f_hz) * g / std::max(g, floor_g);
        meant += square;
        lost += square * (1.0 - given * given);
    }
    return meant > 0.0 ? lost / meant : 0.0;
}

// The nearer of the measured neighbours, in octaves.
double largest_drive(const Calibration& calibration, double frequency_hz) {
    const auto& points = calibration.points;
    auto near = std::ranges::lower_bound(points, frequency_hz, {}, &ResponsePoint::frequency_hz);
    if (near == points.end()) return points.back().largest_drive;
    if (near == points.begin()) return near->largest_drive;
    const auto below = near - 1;
    const bool is_below = frequency_hz * frequency_hz < below->frequency_hz * near->frequency_hz;
    return is_below ? below->largest_drive : near->largest_drive;
}

// Where all was measured up to full scale, the device's own ceiling is limit enough.
double over_measured(const Drive& drive, const Calibration& calibration) {
    const auto is_partial = [](const ResponsePoint& point) {
        return point.largest_drive > 0.0 && point.largest_drive < 1.0;
    };
    if (std::ranges::none_of(calibration.points, is_partial)) return 0.0;
    return largest_of(zero_phase_filtered(drive.samples, drive.rate_hz, [&](double f_hz) {
        const double largest = largest_drive(calibration, f_hz);
        return largest > 0.0 ? 1.0 / largest : 1.0;
    }));
}

// The level at which `reached` meets its limit; a limit of 0 is not known.
double level_within(double limit, double reached) {
    return limit > 0.0 && reached > limit ? limit / reached : 1.0;
}

// ... at which the first limit is met.
double largest_level(const CalibratedDrive& driven, const Calibration& limits) {
    return std::min({level_within(limits.excursion_limit_mm, driven.excursion_mm),
                     level_within(limits.rms_limit, driven.rms),
                     level_within(1.0, driven.over_measured)});
}

std::string turned_down_above(double level) {
    return ": above a level of " + significant_digits(level, 3) + " all of it is turned down";
}

std::vector<std::string> warnings_of(const CalibratedDrive& driven, const Calibration& limits) {
    std::vector<std::string> warnings;
    if (driven.peak > 1.0) {
        warnings.push_back("takes " + significant_digits(driven.peak, 3) +
                           " times the full scale of the actuator; it will be turned down");
    }
    if (limits.excursion_limit_mm > 0.0 && driven.excursion_mm > limits.excursion_limit_mm) {
        warnings.push_back(
            "moves " + significant_digits(driven.excursion_mm, 3) + " mm, farther than the " +
            significant_digits(limits.excursion_limit_mm, 3) + " mm the actuator has" +
            turned_down_above(limits.excursion_limit_mm / driven.excursion_mm));
    }
    if (limits.rms_limit > 0.0 && driven.rms > limits.rms_limit) {
        warnings.push_back("drives it with " + significant_digits(driven.rms, 3) +
                           " of full scale for a second, over and over, more than its " +
                           significant_digits(limits.rms_limit, 3) +
                           turned_down_above(limits.rms_limit / driven.rms));
    }
    if (driven.over_measured > 1.0) {
        warnings.push_back("drives it " + significant_digits(driven.over_measured, 3) +
                           " times as strongly as it was measured" +
                           turned_down_above(1.0 / driven.over_measured));
    }
    if (driven.share_lost >= 0.01) {
        warnings.push_back(percent(driven.share_lost) +
                           " of its energy is where the actuator is weak or was not measured");
    }
    return warnings;
}

}  // namespace

std::string calibration_mismatch(const Calibration& calibration, const DeviceInfo& device,
                                 int channel) {
    if (device.kind == DeviceKind::hid) {
        return "a calibration is of a channel of an audio output, and " + device.name +
               " takes none";
    }
    const std::string made = "this calibration was made for ";
    if (!calibration.device.empty() && calibration.device != device.id) {
        return made + calibration.device + ", not for " + device.id;
    }
    if (calibration.channel == channel) return {};
    return made + "channel " + std::to_string(calibration.channel) + ", not for channel " +
           std::to_string(channel);
}

std::optional<double> response_g(const Calibration& calibration, double frequency_hz) {
    assert(!calibration.points.empty() && "a calibration without a point");
    if (frequency_hz <= 0.0) return std::nullopt;
    // A hair more than it, as 2^(1/3) of a frequency is not a third of an octave to the last bit.
    if (octaves_outside(calibration, frequency_hz) > kReachOctaves + 1e-9) return std::nullopt;
    return interpolated_g(calibration, frequency_hz);
}

CalibratedDrive calibrated_drive(const Waveform& waveform, const Calibration& calibration,
                                 bool loop, std::optional<double> longest_s) {
    assert(!calibration.points.empty() && "a calibration without a point");
    const double floor_g = strongest_g(calibration) / kLargestBoost;
    const std::vector<Gap> gaps = gaps_of(calibration);
    CalibratedDrive driven;
    driven.drive.rate_hz = waveform.rate_hz;
    driven.drive.samples =
        zero_phase_filtered(waveform.samples_g, waveform.rate_hz, [&](double f_hz) {
            const double passed = edge(calibration, gaps, f_hz);
            if (passed == 0.0) return 0.0;
            return passed / std::max(interpolated_g(calibration, f_hz), floor_g);
        });
    if (!loop) soften_end(driven.drive.samples, waveform.rate_hz);
    driven.peak = largest_of(driven.drive.samples);
    driven.excursion_mm = excursion_of_pass_mm(driven.drive, calibration);
    // A single pass, too, is as strong however soon the next one comes.
    driven.rms = std::max(loudest_second(driven.drive), loudest_second_of_loop(driven.drive));
    if (loop) {
        driven.excursion_mm =
            std::max(driven.excursion_mm, excursion_of_loop_mm(driven.drive, calibration));
    }
    if (calibration.excursion_limit_mm > 0.0) {
        driven.drive.travel = travel_by(driven.drive, calibration, loop);
        driven.excursion_mm = std::max(driven.excursion_mm, most_travel_mm(driven.drive.travel));
    }
    // A limit of rms is one of heat; without it nobody knows how warm the actuator gets.
    driven.drive.longest_s = longest_s.value_or(
        calibration.rms_limit > 0.0 ? std::numeric_limits<double>::infinity() : kLongestOnEndS);
    driven.drive.rms_limit = calibration.rms_limit;
    if (calibration.rms_limit <= 0.0) {
        driven.drive.rest_after_s = std::max(kLongestOnEndS, driven.drive.longest_s);
    }
    driven.over_measured = over_measured(driven.drive, calibration);
    driven.share_lost = share_lost(waveform, calibration);
    driven.drive.largest_level = largest_level(driven, calibration);
    driven.warnings = warnings_of(driven, calibration);
    const double length_s = static_cast<double>(waveform.samples_g.size()) / waveform.rate_hz;
    if (!loop && length_s > driven.drive.longest_s) {
        driven.warnings.push_back("ends after " + significant_digits(driven.drive.longest_s, 3) +
                                  " s");
    }
    return driven;
}

std::vector<double> acceleration_g(const Drive& drive, const Calibration& calibration) {
    return zero_phase_filtered(drive.samples, drive.rate_hz, [&](double f_hz) {
        return response_g(calibration, f_hz).value_or(0.0);
    });
}

double peak_displacement_mm(const Waveform& waveform, double lowest_hz) {
    return largest_of(zero_phase_filtered(
        waveform.samples_g, waveform.rate_hz,
        [lowest_hz](double f_hz) { return displaced_mm_per_g(f_hz, lowest_hz); }));
}

}  // namespace tact
