#include "devices/calibration/calibration.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "devices/calibration/calibration_run.h"
#include "devices/calibration/resonance.h"
#include "model/common/random.h"
#include "tests/support/coil.h"

namespace calibration_test {

using namespace tact;
using namespace tact::coil;

TEST_CASE("calibration: between points the response is straight in logarithms, beyond it ends") {
    const Calibration calibration = table();
    CHECK(*response_g(calibration, 100.0) == 1.6);
    CHECK(std::abs(*response_g(calibration, std::sqrt(50.0 * 100.0)) - 0.8) < 1e-12);
    CHECK(*response_g(calibration, 40.0) == 0.4);  // less than a third of an octave below
    CHECK_FALSE(response_g(calibration, 39.0));
    CHECK(response_g(calibration, 251.0));
    CHECK_FALSE(response_g(calibration, 253.0));
    CHECK_FALSE(response_g(calibration, 0.0));
}

TEST_CASE("calibration: stepped tones find the response of a coil to 1 %, wherever they begin") {
    const Coil coil;
    CalibrationParams params;
    params.tone_s = 0.5;
    params.per_octave = 3;
    const CalibrationPlan plan = calibration_plan(params);
    for (const std::size_t before : {0UL, 1234UL, 15'001UL}) {
        CAPTURE(before);
        const auto result = calibration_from(plan, recorded(coil, plan, before, 0.0005));
        REQUIRE(result);
        const auto measured = std::ranges::count(result->points, false, &ResponsePoint::between);
        CHECK(measured == 15);  // from 20 to 500 Hz, 0.33 octaves each
        CHECK(result->points.front().frequency_hz == 20.0);
        CHECK(result->points.back().frequency_hz == 500.0);
        for (const ResponsePoint& point : result->points) {
            const double off = point.g_per_full_scale / coil.gain_at(point.frequency_hz) - 1.0;
            CHECK_MESSAGE(std::abs(off) < 0.01, point.frequency_hz << " Hz: " << off);
            CHECK(point.largest_drive == 0.6);
            CHECK(point.thd < 0.05);
        }
        CHECK(std::abs(result->begins_s - static_cast<double>(before) / kModelRateHz) < 0.011);
    }
}

TEST_CASE("calibration: a sweep finds it too, a little less exactly where it is steep") {
    const Coil coil;
    CalibrationParams params;
    params.is_sweep = true;
    const CalibrationPlan plan = calibration_plan(params);
    const auto result = calibration_from(plan, recorded(coil, plan, 4321, 0.001));
    REQUIRE(result);
    CHECK(result->points.size() >= 25);
    for (const ResponsePoint& point : result->points) {
        const double off = point.g_per_full_scale / coil.gain_at(point.frequency_hz) - 1.0;
        CHECK_MESSAGE(std::abs(off) < 0.05, point.frequency_hz << " Hz: " << off);
    }
}

TEST_CASE("calibration: any resonance is found and followed, tones and sweep, without noise" *
          doctest::test_suite("long")) {
    for (const bool is_sweep : {false, true}) {
        CalibrationParams params;
        params.is_sweep = is_sweep;
        const CalibrationPlan plan = calibration_plan(params);
        for (const double resonance_hz : {60.0, 150.0, 175.0, 300.0}) {
            for (const double q : {1.0, 4.0, 15.0}) {
                CAPTURE(is_sweep);
                CAPTURE(resonance_hz);
                CAPTURE(q);
                const Coil coil{resonance_hz, q, 0.5 / q};
                const auto result = calibration_from(plan, recorded(coil, plan, 4321, 0.0));
                REQUIRE(result);
                CHECK(std::abs(result->begins_s - 0.4321) < 0.03);
                if (is_sweep) continue;
                Calibration calibration;
                calibration.points = result->points;
                double worst_db = 0.0;
                for (double f_hz = 20.0; f_hz < 450.0; f_hz *= 1.007) {
                    const double off = *response_g(calibration, f_hz) / coil.gain_at(f_hz);
                    worst_db = std::max(worst_db, std::abs(20.0 * std::log10(off)));
                }
                CHECK(worst_db < 0.5);
                CHECK(result->remarks.empty());
            }
        }
    }
}

TEST_CASE("calibration: in noise each tone that is taken is as true as it says") {
    const CalibrationPlan plan = calibration_plan({});
    const Coil coil{175.0, 4.0, 0.5};
    const auto result = calibration_from(plan, recorded(coil, plan, 2222, 0.05));
    REQUIRE(result);
    int taken = 0;
    double squares = 0.0;
    for (const MeasuredTone& one : result->tones) {
        if (!one.accepted) continue;
        const double meant_g = one.tone.level * coil.gain_at(one.tone.frequency_hz);
        const double off = one.amplitude_g / meant_g - 1.0;
        CHECK(std::abs(off) < 4.0 * one.standard_error);
        squares += off * off / (one.standard_error * one.standard_error);
        ++taken;
    }
    const auto loud = std::ranges::count_if(
        result->tones, [](const MeasuredTone& one) { return one.snr_db > 20.0; });
    CHECK(taken >= loud + 20);
    CHECK(squares / taken < 1.0);  // the error is half of what is said, as a variance
}

TEST_CASE("calibration: noise, hum and another signal's recording are not the signal") {
    const CalibrationPlan plan = calibration_plan({});
    CalibrationParams other;
    other.low_hz = 60.0;
    other.per_octave = 10;
    RandomStream random{3};
    Waveform noise{kModelRateHz, std::vector<double>(plan.drive.samples.size() + 60'000)};
    Waveform hum = noise;
    for (std::size_t n = 0; n < noise.samples_g.size(); ++n) {
        noise.samples_g[n] = next_normal(random);
        hum.samples_g[n] = std::sin(kTau * 50.0 * static_cast<double>(n) / kModelRateHz);
    }
    CHECK_FALSE(calibration_from(plan, noise));
    CHECK_FALSE(calibration_from(plan, hum));
    CHECK_FALSE(calibration_from(plan, recorded(Coil{}, calibration_plan(other), 9000, 0.0)));
}

TEST_CASE("calibration: where neighbours tell two resonances apart, what may be wrong is said") {
    std::vector<ResponsePoint> points;
    for (int k = 0; k < 20; ++k) {
        const double f_hz = 40.0 * std::exp2(k / 6.0);
        const double both =
            Coil{100.0, 15.0, 0.1}.gain_at(f_hz) + Coil{118.0, 15.0, 0.1}.gain_at(f_hz);
        points.push_back({f_hz, both});
    }
    const FinerTable finer = finer_table(points);
    REQUIRE_FALSE(finer.remarks.empty());
    CHECK(finer.remarks[0].find("between ") == 0);
    // A flat response is left as it was.
    const std::vector<ResponsePoint> flat{{50.0, 1.0}, {70.0, 1.0}, {100.0, 1.0}, {140.0, 1.0}};
    CHECK(finer_table(flat).points == flat);
    CHECK(finer_table({{50.0, 1.0}, {60.0, 9.0}}).points.size() == 2);
    CHECK(finer_table({}).points.empty());
}

TEST_CASE("calibration: whose it is, is said where it is another's") {
    Calibration calibration = table();
    calibration.device = "audio:ALSA:card";
    calibration.channel = 3;
    DeviceInfo device;
    device.id = "audio:ALSA:card";
    device.name = "a card";
    CHECK(calibration_mismatch(calibration, device, 3).empty());
    CHECK(calibration_mismatch(calibration, device, 1) ==
          "this calibration was made for channel 3, not for channel 1");
    device.id = "audio:ALSA:other";
    CHECK(calibration_mismatch(calibration, device, 3) ==
          "this calibration was made for audio:ALSA:card, not for audio:ALSA:other");
    calibration.device.clear();
    CHECK(calibration_mismatch(calibration, device, 3).empty());
    device.kind = DeviceKind::hid;
    device.name = "Joy-Con (L)";
    CHECK(calibration_mismatch(calibration, device, 3).find("Joy-Con (L) takes none") !=
          std::string::npos);
}

TEST_CASE("calibration: distortion and departure from proportional are told, bad tones left out") {
    Coil coil;
    coil.cubic = 0.4;
    CalibrationParams params;
    params.tone_s = 0.4;
    params.low_hz = 150.0;
    params.high_hz = 300.0;
    const CalibrationPlan plan = calibration_plan(params);
    const auto result = calibration_from(plan, recorded(coil, plan, 100, 1e-5));
    REQUIRE(result);
    for (const ResponsePoint& point : result->points) {
        // y + c y^3 of a sine A: fundamental A + 3/4 c A^3, third harmonic c A^3 / 4.
        const double a = coil.gain_at(point.frequency_hz) * 0.6;
        const double c = coil.cubic;
        const double fundamental = a + 0.75 * c * a * a * a;
        CHECK(std::abs(point.thd - 0.25 * c * a * a * a / fundamental) < 1e-3);
        CHECK(std::abs(point.g_per_full_scale - fundamental / 0.6) < 1e-3 * fundamental);
        CHECK(point.nonlinearity > 0.01);
    }
    const auto noisy = calibration_from(plan, recorded(Coil{}, plan, 100, 0.05));
    if (noisy) {
        for (const MeasuredTone& tone : noisy->tones) {
            CHECK(tone.accepted == (tone.standard_error < 0.03 && tone.thd < 0.1));
        }
    }
    CHECK_FALSE(calibration_from(plan, recorded(Coil{}, plan, 100, 5.0)));
}

TEST_CASE("calibration: what is not the plan's recording is refused with a sentence") {
    const CalibrationPlan plan = calibration_plan({});
    Waveform other{kModelRateHz, std::vector<double>(plan.drive.samples.size() + 100, 0.0)};
    auto answer = calibration_from(plan, other);
    REQUIRE_FALSE(answer);
    CHECK(answer.error().message.find("not in this recording") != std::string::npos);
    other.samples_g.resize(1000);
    answer = calibration_from(plan, other);
    REQUIRE_FALSE(answer);
    CHECK(answer.error().message.find("whole calibration signal") != std::string::npos);
    other.rate_hz = 8000.0;
    CHECK_FALSE(calibration_from(plan, other));
}

TEST_CASE("calibration: other tones at the plan's frequencies are not the plan") {
    CalibrationParams params;
    params.tone_s = 0.4;
    params.per_octave = 3;
    const CalibrationPlan plan = calibration_plan(params);
    CalibrationPlan backwards = plan;
    std::ranges::reverse(backwards.drive.samples);
    CHECK_FALSE(calibration_from(plan, recorded(Coil{}, backwards, 5000, 0.0)));
    // Nor are the same tones, longer or shorter ones.
    for (const double tone_s : {0.2, 0.3, 0.8}) {
        CAPTURE(tone_s);
        CalibrationParams other = params;
        other.tone_s = tone_s;
        other.settle_s = 0.05;
        CalibrationPlan played = calibration_plan(other);
        played.drive.samples.resize(
            std::max(played.drive.samples.size(), plan.drive.samples.size()));
        CHECK_FALSE(calibration_from(plan, recorded(Coil{}, played, 5000, 0.0)));
    }
}

}  // namespace calibration_test
