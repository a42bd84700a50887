// An actuator measured by its own recording, and then driven by the table: what it does is what was
// meant, or less; what the table says of its errors is no less than they are.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <functional>
#include <numbers>
#include <vector>

#include "devices/calibration/calibration.h"
#include "devices/calibration/calibration_run.h"
#include "model/signal/resample.h"
#include "tests/support/coil.h"

namespace round_trip_test {

using namespace tact;
using namespace tact::coil;

namespace {

using Actuator = std::function<std::vector<double>(const std::vector<double>&)>;

Actuator flat() {
    return [](const std::vector<double>& drive) { return drive; };
}

Actuator resonant(double resonance_hz, double q) {
    return [=](const std::vector<double>& drive) {
        return Coil{resonance_hz, q, 1.0 / q}.moved(drive);
    };
}

// A coil whose magnet gives out: in proportion up to a third of full scale or so.
Actuator saturating(double at_g) {
    return [=](const std::vector<double>& drive) {
        std::vector<double> moved = drive;
        for (double& sample : moved) sample = at_g * std::tanh(sample / at_g);
        return moved;
    };
}

Waveform recorded_of(const Actuator& actuator, const CalibrationPlan& plan, double clock = 1.0) {
    std::vector<double> drive(3000, 0.0);
    drive.insert(drive.end(), plan.drive.samples.begin(), plan.drive.samples.end());
    drive.resize(drive.size() + 12'000, 0.0);
    Waveform moved{kModelRateHz, actuator(drive)};
    // A sensor that takes `clock` times as many samples as it says.
    if (clock != 1.0) moved = resampled(moved, kModelRateHz * clock);
    moved.rate_hz = kModelRateHz;
    return moved;
}

// By a sum against a cosine and a sine, over whole periods from the middle half.
double amplitude_at(const std::vector<double>& samples, double f_hz) {
    const double period = kModelRateHz / f_hz;
    const auto from = samples.size() / 4;
    const double periods = std::floor(static_cast<double>(samples.size()) / 2.0 / period);
    const auto count = static_cast<std::size_t>(std::lround(periods * period));
    std::complex<double> sum = 0.0;
    for (std::size_t n = from; n < from + count; ++n) {
        sum += samples[n] * std::polar(1.0, -kTau * f_hz * static_cast<double>(n) / kModelRateHz);
    }
    return 2.0 * std::abs(sum) / static_cast<double>(count);
}

std::vector<double> tone(double f_hz, double amplitude_g, double duration_s) {
    std::vector<double> samples(sample_count(duration_s, kModelRateHz));
    for (std::size_t n = 0; n < samples.size(); ++n) {
        samples[n] = amplitude_g * std::sin(kTau * f_hz * static_cast<double>(n) / kModelRateHz);
    }
    return samples;
}

// What is felt over what was meant, dB.
double felt_db(const Actuator& actuator, const Calibration& calibration, double f_hz,
               double amplitude_g) {
    const CalibratedDrive driven =
        calibrated_drive({kModelRateHz, tone(f_hz, amplitude_g, 2.0)}, calibration);
    std::vector<double> drive = driven.drive.samples;
    const double level =
        std::min(driven.drive.largest_level, driven.peak > 1.0 ? 1.0 / driven.peak : 1.0);
    for (double& sample : drive) sample *= level;
    return 20.0 * std::log10(amplitude_at(actuator(drive), f_hz) / amplitude_g);
}

Calibration measured(const Actuator& actuator, const CalibrationParams& params) {
    const auto result =
        calibration_from(calibration_plan(params), recorded_of(actuator, calibration_plan(params)));
    REQUIRE(result);
    Calibration calibration;
    calibration.points = result->points;
    return calibration;
}

}  // namespace

TEST_CASE("round trip: what is felt is what was meant from 5 Hz on, and never more by 1 dB" *
          doctest::test_suite("long")) {
    CalibrationParams params;
    params.low_hz = 5.0;
    params.tone_s = 0.8;
    params.settle_s = 0.4;
    params.per_octave = 6;
    params.levels = {0.05, 0.1, 0.3};
    for (const Actuator& actuator : {flat(), resonant(80.0, 3.0), saturating(0.3)}) {
        const Calibration calibration = measured(actuator, params);
        for (const double f_hz : {5.0, 8.0, 13.0, 31.0, 75.0, 150.0, 310.0}) {
            for (const double amplitude_g : {0.002, 0.02, 0.06}) {
                CAPTURE(f_hz);
                CAPTURE(amplitude_g);
                const double off_db = felt_db(actuator, calibration, f_hz, amplitude_g);
                CHECK(off_db < 1.0);
                if (*response_g(calibration, f_hz) > 0.12 && amplitude_g < 0.03) {
                    CHECK(off_db > -1.2);
                }
            }
        }
    }
}

TEST_CASE("round trip: a saturating actuator is driven up to where it is in proportion") {
    CalibrationParams params;
    params.tone_s = 0.4;
    params.per_octave = 2;
    const CalibrationPlan plan = calibration_plan(params);
    const auto result = calibration_from(plan, recorded_of(saturating(0.5), plan));
    REQUIRE(result);
    for (const ResponsePoint& point : result->points) {
        CHECK(point.largest_drive < 0.6);
        CHECK(point.nonlinearity <= 0.12);
    }
    REQUIRE_FALSE(result->remarks.empty());
    CHECK(result->remarks.back().find("in proportion") != std::string::npos);
}

TEST_CASE("round trip: what is out of proportion already at low levels is left out, and said") {
    CalibrationParams params;
    params.tone_s = 0.4;
    params.per_octave = 2;
    params.high_hz = 640.0;  // so that 40 Hz is one of the steps
    const CalibrationPlan plan = calibration_plan(params);
    Waveform recorded = recorded_of(flat(), plan);
    // At 40 Hz the weaker, the stronger: 275 % off.
    for (const CalibrationTone& tone : plan.tones) {
        if (std::abs(tone.frequency_hz - 40.0) > 1.0) continue;
        const double by = tone.level < 0.2 ? 3.75 : tone.level < 0.5 ? 1.7 : 1.0;
        for (std::size_t n = tone.begin; n < tone.end; ++n) recorded.samples_g[3000 + n] *= by;
    }
    const auto result = calibration_from(plan, recorded);
    REQUIRE(result);
    for (const ResponsePoint& point : result->points) {
        CHECK(point.unknown == (std::abs(point.frequency_hz - 40.0) < 1.0));
        if (point.unknown) continue;
        CHECK(std::abs(point.g_per_full_scale - 1.0) < 0.01);
    }
    CHECK(std::ranges::any_of(result->remarks, [](const std::string& remark) {
        return remark.find("left out 40 Hz") == 0;
    }));
}

TEST_CASE("round trip: a clock that is off is told by the signal itself, and taken out" *
          doctest::test_suite("long")) {
    CalibrationParams params;
    params.per_octave = 4;
    const CalibrationPlan plan = calibration_plan(params);
    const Coil coil{150.0, 4.0, 0.5};
    for (const double clock : {0.97, 0.99, 0.999, 1.0, 1.004, 1.02}) {
        CAPTURE(clock);
        const auto result = calibration_from(
            plan, recorded_of([&](const auto& drive) { return coil.moved(drive); }, plan, clock));
        REQUIRE(result);
        // 2 % fewer samples are 2 % higher frequencies.
        CHECK(std::abs((1.0 + result->clock_off) * clock - 1.0) < 1e-4);
        for (const ResponsePoint& point : result->points) {
            const double off = point.g_per_full_scale / coil.gain_at(point.frequency_hz) - 1.0;
            CHECK_MESSAGE(std::abs(off) < 0.01, point.frequency_hz << " Hz: " << off);
        }
        const bool is_told = std::ranges::any_of(result->remarks, [](const std::string& remark) {
            return remark.find("the clock of this recording runs") == 0;
        });
        CHECK(is_told == (clock != 1.0));
    }
}

TEST_CASE("round trip: the clock of a sweep is told, too, beside a resonance" *
          doctest::test_suite("long")) {
    CalibrationParams params;
    params.is_sweep = true;
    const CalibrationPlan plan = calibration_plan(params);
    for (const double q : {1.0, 25.0}) {
        const Coil coil{150.0, q, 1.0 / q};
        for (const double clock : {0.98, 0.995, 1.0, 1.01}) {
            CAPTURE(q);
            CAPTURE(clock);
            const auto result = calibration_from(
                plan,
                recorded_of([&](const auto& drive) { return coil.moved(drive); }, plan, clock));
            REQUIRE(result);
            CHECK(std::abs((1.0 + result->clock_off) * clock - 1.0) < 4e-4);
            if (clock == 1.0) CHECK(result->clock_off == 0.0);
        }
    }
}

TEST_CASE("round trip: on a sharp resonance what is told is no less than what the table errs") {
    for (const bool is_sweep : {false, true}) {
        for (const double resonance_hz : {97.0, 150.0, 163.0}) {
            CalibrationParams params;
            params.is_sweep = is_sweep;
            const CalibrationPlan plan = calibration_plan(params);
            const Coil coil{resonance_hz, 25.0, 0.04};
            const auto result = calibration_from(
                plan, recorded_of([&](const auto& drive) { return coil.moved(drive); }, plan));
            REQUIRE(result);
            Calibration calibration;
            calibration.points = result->points;
            // Between two measured frequencies without a word, 1 dB at most.
            for (double f_hz = 25.0; f_hz < 400.0; f_hz *= 1.01) {
                const double off_db =
                    20.0 * std::log10(*response_g(calibration, f_hz) / coil.gain_at(f_hz));
                const bool is_told =
                    std::ranges::any_of(result->remarks, [&](const std::string& remark) {
                        double low = 0.0;
                        double high = 0.0;
                        return std::sscanf(remark.c_str(), "between %lf and %lf Hz", &low, &high) ==
                                   2 &&
                               f_hz >= low - 1.0 && f_hz <= high + 1.0;
                    });
                CAPTURE(is_sweep);
                CAPTURE(resonance_hz);
                CAPTURE(f_hz);
                if (!is_told) CHECK(std::abs(off_db) < 1.0);
            }
        }
    }
}

namespace {

// "between 143 and 160 Hz strengths may be wrong by 9.1 dB": of the interval that begins at
// `from_hz`; 0 where nothing is told.
double told_db(const CalibrationResult& result, double from_hz) {
    for (const std::string& remark : result.remarks) {
        double low_hz = 0.0;
        double high_hz = 0.0;
        if (std::sscanf(remark.c_str(), "between %lf and %lf Hz", &low_hz, &high_hz) != 2) continue;
        if (std::abs(low_hz - from_hz) > 1.0) continue;
        const std::size_t at = remark.find("wrong by ");
        return at == std::string::npos ? 99.0 : std::stod(remark.substr(at + 9));
    }
    return 0.0;
}

// What is told bounds the error, and is no more than 3 dB above it.
void check_told(const CalibrationResult& result, const std::function<double(double)>& truth_g) {
    Calibration calibration;
    calibration.points = result.points;
    double from_hz = 0.0;
    for (const ResponsePoint& point : result.points) {
        if (point.between) continue;
        double most_db = 0.0;
        for (double share = 0.0; from_hz > 0.0 && share <= 1.0; share += 0.05) {
            const double f_hz = from_hz * std::pow(point.frequency_hz / from_hz, share);
            most_db = std::max(most_db, std::abs(20.0 * std::log10(*response_g(calibration, f_hz) /
                                                                   truth_g(f_hz))));
        }
        const double told = told_db(result, from_hz);
        CAPTURE(from_hz);
        CHECK(most_db <= std::max(told, 0.5));
        CHECK(told <= most_db + 3.0);
        from_hz = point.frequency_hz;
    }
}

}  // namespace

TEST_CASE("round trip: the doubt that is told bounds the error, and is not far above it" *
          doctest::test_suite("long")) {
    for (const bool is_sweep : {false, true}) {
        for (const double low_hz : {5.0, 20.0}) {
            CalibrationParams params;
            params.is_sweep = is_sweep;
            params.low_hz = low_hz;
            if (low_hz < 20.0) {
                params.tone_s = 0.8;
                params.settle_s = 0.4;
            }
            const CalibrationPlan plan = calibration_plan(params);
            CAPTURE(is_sweep);
            CAPTURE(low_hz);
            const auto level = calibration_from(plan, recorded_of(flat(), plan));
            REQUIRE(level);
            check_told(*level, [](double) { return 1.0; });
            for (const double q : {4.0, 10.0, 25.0}) {
                for (const double resonance_hz : {60.0, 150.0, 163.0}) {
                    if (low_hz < 20.0 && resonance_hz != 60.0) continue;
                    CAPTURE(q);
                    CAPTURE(resonance_hz);
                    const Coil coil{resonance_hz, q, 1.0 / q};
                    const auto result = calibration_from(
                        plan,
                        recorded_of([&](const auto& drive) { return coil.moved(drive); }, plan));
                    REQUIRE(result);
                    check_told(*result, [&](double f_hz) { return coil.gain_at(f_hz); });
                }
            }
        }
    }
}

TEST_CASE("round trip: a sharp resonance is worked out beside a sensor's noise, too, and told") {
    CalibrationParams params;
    params.is_sweep = true;
    const CalibrationPlan plan = calibration_plan(params);
    const Coil coil{97.0, 25.0, 0.04};
    const auto result = calibration_from(plan, recorded(coil, plan, 500, 1e-3));
    REQUIRE(result);
    check_told(*result, [&](double f_hz) { return coil.gain_at(f_hz); });
    CHECK(std::ranges::any_of(result->remarks, [](const std::string& remark) {
        return remark.find("at 97 Hz it rings (Q 2") == 0;
    }));
}

}  // namespace round_trip_test
