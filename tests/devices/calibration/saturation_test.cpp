// Actuators that give out: measured by their own recordings and driven by the table, they are never
// driven stronger than meant by more than 1 dB, and what is told of the table is no less than what
// it errs by.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <string>
#include <vector>

#include "devices/calibration/calibration.h"
#include "devices/calibration/calibration_run.h"
#include "tests/support/coil.h"

namespace saturation_test {

using namespace tact;
using namespace tact::coil;

namespace {

// x / (1 + |x / at|^h)^(1 / h): the greater h, the harder the knee.
struct Knee {
    double at = 1e9;
    double hardness = 2.0;

    double of(double x) const {
        return x / std::pow(1.0 + std::pow(std::abs(x / at), hardness), 1.0 / hardness);
    }
};

// An amplifier, a coil on its spring, and what holds the mass.
struct Made {
    Coil coil;
    bool is_flat = false;
    Knee amplifier;
    Knee magnet;
    double noise_g = 0.0;

    std::vector<double> moved(std::vector<double> drive) const {
        for (double& sample : drive) sample = amplifier.of(sample);
        std::vector<double> made = is_flat ? drive : coil.moved(drive);
        for (double& sample : made) sample = magnet.of(sample);
        return made;
    }
    // Gain at a drive so weak that nothing gives out.
    double truth_g(double f_hz) const { return is_flat ? 1.0 : coil.gain_at(f_hz); }
    // What a sine gives once it is steady.
    double felt_g(double f_hz, double drive) const {
        std::vector<double> samples(20'000);
        for (std::size_t n = 0; n < samples.size(); ++n) {
            samples[n] = drive * std::sin(kTau * f_hz * static_cast<double>(n) / kModelRateHz);
        }
        const std::vector<double> made = moved(samples);
        const double period = kModelRateHz / f_hz;
        const auto whole =
            static_cast<std::size_t>(std::round(std::floor(8000.0 / period) * period));
        double re = 0.0;
        double im = 0.0;
        for (std::size_t n = made.size() - whole; n < made.size(); ++n) {
            const double p = kTau * f_hz * static_cast<double>(n) / kModelRateHz;
            re += made[n] * std::cos(p);
            im += made[n] * std::sin(p);
        }
        return 2.0 * std::hypot(re, im) / static_cast<double>(whole);
    }
};

Waveform recorded_of(const Made& made, const CalibrationPlan& plan) {
    std::vector<double> drive(3000, 0.0);
    drive.insert(drive.end(), plan.drive.samples.begin(), plan.drive.samples.end());
    drive.resize(drive.size() + 12'000, 0.0);
    Waveform waveform{kModelRateHz, made.moved(drive)};
    RandomStream random{11};
    for (double& sample : waveform.samples_g) sample += made.noise_g * next_normal(random);
    return waveform;
}

double decibels(double ratio) { return 20.0 * std::log10(ratio); }

// What the remarks say that strengths may be wrong by at a frequency: dB, without end where it is
// said not to be known.
double told_db(const std::vector<std::string>& remarks, double f_hz) {
    double most = 0.0;
    for (const std::string& remark : remarks) {
        double low_hz = 0.0;
        double high_hz = 0.0;
        const char* text = remark.c_str();
        int count = 0;
        if (std::sscanf(text, "between %lf and %lf Hz", &low_hz, &high_hz) != 2 &&
            std::sscanf(text, "at %d frequencies from %lf to %lf Hz", &count, &low_hz, &high_hz) !=
                3) {
            if (std::sscanf(text, "at %lf Hz", &low_hz) != 1) continue;
            high_hz = low_hz;
        }
        // Straight lines lead from the last frequency to its neighbours.
        const double beside = std::exp2(1.0 / 6.0) * 1.01;
        if (f_hz < low_hz / beside || f_hz > high_hz * beside) continue;
        const bool is_unknown = remark.find("not known") != std::string::npos ||
                                remark.find("bends too much") != std::string::npos;
        const std::size_t by = remark.find("by ");
        if (is_unknown) most = std::numeric_limits<double>::infinity();
        if (remark.find("may be") != std::string::npos && by != std::string::npos) {
            most = std::max(most, std::strtod(remark.c_str() + by + 3, nullptr));
        }
    }
    return most;
}

bool is_in_gap(const std::vector<ResponsePoint>& points, double f_hz) {
    for (std::size_t k = 0; k < points.size(); ++k) {
        if (!points[k].unknown) continue;
        const double low_hz = k == 0 ? 0.0 : points[k - 1].frequency_hz;
        const double high_hz = k + 1 == points.size() ? 1e9 : points[k + 1].frequency_hz;
        if (f_hz > low_hz && f_hz < high_hz) return true;
    }
    return false;
}

// The drive of a lasting sine, by the table as calibrated_drive() divides by it.
double drive_of(const Calibration& calibration, double f_hz, double amplitude_g) {
    std::vector<double> samples(10'000);
    for (std::size_t n = 0; n < samples.size(); ++n) {
        samples[n] = amplitude_g * std::sin(kTau * f_hz * static_cast<double>(n) / kModelRateHz);
    }
    const CalibratedDrive driven = calibrated_drive({kModelRateHz, samples}, calibration);
    double peak = 0.0;
    for (std::size_t n = 3000; n < 7000; ++n) {
        peak = std::max(peak, std::abs(driven.drive.samples[n]));
    }
    return peak * std::min(driven.drive.largest_level, driven.peak > 1.0 ? 1.0 / driven.peak : 1.0);
}

struct Worst {
    double untold_db = -99.0;  // error of the table beyond 1 dB and what is told
    double above_db = -99.0;   // felt over meant
    std::vector<ResponsePoint> points;
    std::string remarks;
};

Worst worst_of(const Made& made, const CalibrationParams& params) {
    const auto result = calibration_from(params, recorded_of(made, calibration_plan(params)));
    Worst worst;
    if (!result) return {-99.0, -99.0, {}, result.error().message};
    Calibration calibration;
    calibration.points = worst.points = result->points;
    for (const std::string& remark : result->remarks) worst.remarks += remark + "\n";
    const double from_hz = result->points.front().frequency_hz;
    const double to_hz = result->points.back().frequency_hz;
    for (double f_hz = from_hz; f_hz <= to_hz; f_hz *= std::exp2(1.0 / 48.0)) {
        if (is_in_gap(result->points, f_hz)) continue;
        const double off_db = decibels(*response_g(calibration, f_hz) / made.truth_g(f_hz));
        const double told = std::max(1.0, told_db(result->remarks, f_hz));
        worst.untold_db = std::max(worst.untold_db, std::abs(off_db) - told);
    }
    for (double f_hz = from_hz * 1.01; f_hz <= to_hz; f_hz *= std::exp2(1.0 / 5.0)) {
        for (const double amplitude_g : {0.01, 0.1}) {
            const double felt_g = made.felt_g(f_hz, drive_of(calibration, f_hz, amplitude_g));
            worst.above_db = std::max(worst.above_db, decibels(felt_g / amplitude_g));
        }
    }
    return worst;
}

void check(const Made& made, const CalibrationParams& params) {
    const Worst worst = worst_of(made, params);
    CAPTURE(params.is_sweep);
    CAPTURE(params.low_hz);
    CAPTURE(made.is_flat);
    CAPTURE(made.coil.resonance_hz);
    CAPTURE(made.coil.q);
    CAPTURE(made.amplifier.at);
    CAPTURE(made.magnet.at);
    CAPTURE(made.magnet.hardness);
    CAPTURE(made.noise_g);
    CAPTURE(worst.remarks);
    CHECK((!worst.points.empty() || !worst.remarks.empty()));
    CHECK(worst.untold_db <= 0.0);
    CHECK(worst.above_db <= 1.0);
}

CalibrationParams params_of(bool is_sweep, double low_hz) {
    CalibrationParams params;
    params.is_sweep = is_sweep;
    params.low_hz = low_hz;
    if (low_hz >= 20.0) return params;
    params.tone_s = 0.8;
    params.settle_s = 0.4;
    return params;
}

Made made_of(double resonance_hz, double q, Knee magnet, Knee amplifier, double noise_g) {
    Made made;
    made.is_flat = q == 0.0;
    if (q > 0.0) made.coil = {resonance_hz, q, 1.0 / q};
    made.magnet = magnet;
    made.amplifier = amplifier;
    made.noise_g = noise_g;
    return made;
}

}  // namespace

TEST_CASE(
    "saturation: tones: the error told is no less than the true one, and no drive is 1 dB "
    "too strong" *
    doctest::test_suite("long")) {
    for (const double q : {0.0, 3.0, 10.0, 25.0}) {
        for (const double resonance_hz : {60.0, 163.0}) {
            if (q == 0.0 && resonance_hz > 100.0) continue;
            for (const Knee knee : {Knee{}, Knee{0.5, 1.0}, Knee{0.5, 8.0}, Knee{0.08, 2.0},
                                    Knee{0.08, 8.0}, Knee{0.02, 1.0}}) {
                const double noise_g = knee.hardness > 1.5 ? 1e-3 : 0.0;
                check(made_of(resonance_hz, q, knee, {}, noise_g), params_of(false, 20.0));
            }
            check(made_of(resonance_hz, q, {}, {0.5, 2.0}, 1e-4), params_of(false, 20.0));
            check(made_of(resonance_hz, q, {0.08, 2.0}, {}, 1e-3), params_of(false, 5.0));
        }
    }
}

TEST_CASE(
    "saturation: sweeps: the error told is no less than the true one, and no drive is 1 dB "
    "too strong" *
    doctest::test_suite("long")) {
    for (const double q : {3.0, 25.0}) {
        for (const Knee knee : {Knee{}, Knee{0.5, 1.0}, Knee{0.08, 2.0}, Knee{0.08, 8.0}}) {
            check(made_of(163.0, q, knee, {}, 1e-3), params_of(true, 20.0));
        }
    }
    check(made_of(60.0, 25.0, {0.08, 2.0}, {}, 1e-3), params_of(true, 5.0));
}

TEST_CASE("saturation: a sweep tells up to where an actuator follows, and sends no more") {
    const CalibrationParams params = params_of(true, 20.0);
    const Made made = made_of(163.0, 25.0, {0.08, 2.0}, {}, 1e-4);
    const auto result = calibration_from(params, recorded_of(made, calibration_plan(params)));
    REQUIRE(result);
    const auto near =
        std::ranges::lower_bound(result->points, 150.0, {}, &ResponsePoint::frequency_hz);
    CHECK(near->largest_drive < 0.6);
    CHECK(result->points.back().largest_drive == 0.6);
    CHECK(std::ranges::any_of(result->remarks, [](const std::string& remark) {
        return remark.find("is in proportion to its drive") != std::string::npos &&
               remark.find(" g only: no more is sent there") != std::string::npos;
    }));
    // All of it is played within a minute.
    const Drive drive = calibration_plan(params).drive;
    CHECK(static_cast<double>(drive.samples.size()) < 60.0 * drive.rate_hz);
}

TEST_CASE("saturation: a recording of one sweep, as they once were, is read, and its doubt told") {
    CalibrationParams once = params_of(true, 20.0);
    once.sweep_levels = {0.6};
    once.sweep_s = 20.0;
    const Made made = made_of(163.0, 3.0, {}, {}, 1e-4);
    const auto result =
        calibration_from(params_of(true, 20.0), recorded_of(made, calibration_plan(once)));
    REQUIRE(result);
    CHECK(std::abs(decibels(result->points[10].g_per_full_scale /
                            made.truth_g(result->points[10].frequency_hz))) < 0.5);
    CHECK(result->remarks.back().find("whether the actuator is in proportion to its drive is not "
                                      "known") != std::string::npos);
}

TEST_CASE("saturation: nothing is sent between the points around one that is not known") {
    Calibration calibration;
    calibration.points = {{50.0, 1.0}, {100.0, 1.0}, {141.0, 1.0}, {200.0, 1.0}, {400.0, 1.0}};
    calibration.points[2].unknown = true;
    CHECK(drive_of(calibration, 141.0, 0.1) < 1e-4);
    CHECK(drive_of(calibration, 120.0, 0.1) < 1e-3);
    CHECK(std::abs(drive_of(calibration, 300.0, 0.1) - 0.1) < 1e-3);
    CHECK(std::abs(drive_of(calibration, 70.0, 0.1) - 0.1) < 1e-3);
}

}  // namespace saturation_test
