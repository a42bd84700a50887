// What a calibration makes of a vibration: the drive, what is lost, and what it warns of.
#include "devices/calibration/calibration.h"

#include <doctest/doctest.h>

#include <cmath>

#include "tests/support/coil.h"
#include "tests/support/tones.h"

namespace calibrated_drive_test {

using namespace tact;
using namespace tact::coil;

TEST_CASE("calibration: no frequency is boosted by more than 20 dB over the strongest") {
    Calibration calibration;
    calibration.points = {{50.0, 0.01}, {70.0, 0.01}, {100.0, 1.0}, {200.0, 1.0}};
    const auto middle_of = [&](double f_hz) {
        const CalibratedDrive driven =
            calibrated_drive(tone(f_hz, kModelRateHz, 20'000, 0.01), calibration);
        double most = 0.0;
        for (std::size_t n = 8000; n < 12'000; ++n) {
            most = std::max(most, std::abs(driven.drive.samples[n]));
        }
        return most;
    };
    CHECK(std::abs(middle_of(150.0) - 0.01) < 1e-4);
    CHECK(std::abs(middle_of(60.0) - 0.1) < 3e-3);  // not 1, which 0.01 g would take
}

TEST_CASE("calibration: driven by it, the coil does what was meant") {
    const Coil coil;
    CalibrationParams params;
    params.per_octave = 12;
    params.tone_s = 0.3;
    params.settle_s = 0.15;
    const CalibrationPlan plan = calibration_plan(params);
    const auto result = calibration_from(plan, recorded(coil, plan, 500, 1e-5));
    REQUIRE(result);
    Calibration calibration;
    calibration.points = result->points;
    // Away from the ends, where the filter has settled.
    const Waveform meant = mixed(1.0, tone(80.0, kModelRateHz, 10'000, 0.2), 1.0,
                                 tone(250.0, kModelRateHz, 10'000, 0.1));
    const CalibratedDrive driven = calibrated_drive(meant, calibration);
    CHECK(driven.share_lost < 1e-3);
    CHECK(driven.warnings.empty());
    const std::vector<double> felt = coil.moved(driven.drive.samples);
    for (const auto& [f_hz, amplitude_g] : {std::pair{80.0, 0.2}, {250.0, 0.1}}) {
        double c = 0.0;
        double s = 0.0;
        for (std::size_t n = 2000; n < 8000; ++n) {  // whole cycles of both
            c += felt[n] * std::cos(kTau * f_hz * static_cast<double>(n) / kModelRateHz) / 3000.0;
            s += felt[n] * std::sin(kTau * f_hz * static_cast<double>(n) / kModelRateHz) / 3000.0;
        }
        CHECK(std::abs(std::hypot(c, s) / amplitude_g - 1.0) < 0.02);
    }
}

TEST_CASE("calibration: too much is said before it is played") {
    Calibration calibration = table();
    calibration.excursion_limit_mm = 0.05;
    calibration.rms_limit = 0.3;
    const Waveform strong = tone(50.0, kModelRateHz, 10'000, 1.0);
    const CalibratedDrive driven = calibrated_drive(strong, calibration);
    CHECK(driven.peak > 2.4);  // 1 g at 0.4 g per full scale
    CHECK(driven.peak < 2.7);
    CHECK(driven.warnings.size() == 3);
    // Begun slowly, 1 g of 50 Hz moves 0.0994 mm; begun at once, up to twice as far.
    CHECK(driven.excursion_mm < 2.0 * 0.1);
    Waveform slow = strong;
    for (std::size_t n = 0; n < 10'000; ++n) {
        slow.samples_g[n] *= 0.5 - 0.5 * std::cos(kTau * static_cast<double>(n) / 10'000.0);
    }
    CHECK(std::abs(peak_displacement_mm(slow) - 0.0994) < 0.001);
    const Waveform high = tone(400.0, kModelRateHz, 10'000, 0.1);
    CHECK(calibrated_drive(high, calibration).share_lost > 0.99);
    CHECK(calibrated_drive({}, calibration).drive.samples.empty());
    const CalibratedDrive silent =
        calibrated_drive({kModelRateHz, std::vector<double>(500, 0.0)}, calibration);
    CHECK(silent.peak == 0.0);
    CHECK(silent.warnings.empty());
}

}  // namespace calibrated_drive_test
