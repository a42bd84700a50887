// What a calibrated actuator is spared over time: laws over loops, slow motion and lengths, each
// computed here again from the drive that goes out.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "devices/calibration/calibration.h"
#include "devices/calibration/calibration_file.h"
#include "devices/device/protection.h"

namespace limits_test {

using namespace tact;

namespace {

// An actuator of 1 g per full scale, measured from 2 Hz on.
Calibration flat() {
    Calibration calibration;
    for (double f_hz = 2.0; f_hz < 520.0; f_hz *= std::exp2(1.0 / 3.0)) {
        calibration.points.push_back({f_hz, 1.0});
    }
    return calibration;
}

Waveform tone(double f_hz, double amplitude_g, double duration_s) {
    Waveform waveform;
    const auto count = static_cast<std::size_t>(std::lround(duration_s * waveform.rate_hz));
    for (std::size_t n = 0; n < count; ++n) {
        const double t_s = static_cast<double>(n) / waveform.rate_hz;
        waveform.samples_g.push_back(amplitude_g * std::sin(2.0 * std::numbers::pi * f_hz * t_s));
    }
    return waveform;
}

// The loudest second of the drive, which is repeated for at least three seconds where it loops.
double loudest_second(const Drive& drive, bool loop) {
    std::vector<double> all = drive.samples;
    while (loop && static_cast<double>(all.size()) < 3.0 * drive.rate_hz) {
        all.insert(all.end(), drive.samples.begin(), drive.samples.end());
    }
    const auto window = static_cast<std::size_t>(drive.rate_hz);
    double most = 0.0;
    double sum = 0.0;
    for (std::size_t n = 0; n < all.size(); ++n) {
        sum += all[n] * all[n];
        if (n >= window) sum -= all[n - window] * all[n - window];
        most = std::max(most, sum);
    }
    return std::sqrt(most / static_cast<double>(window));
}

}  // namespace

TEST_CASE("limits: a loop of any length has the rms of its repetition, and keeps to the limit") {
    Calibration calibration = flat();
    calibration.rms_limit = 0.1;
    for (const double length_s : {0.02, 0.05, 0.1, 0.2, 0.37, 0.5, 0.9, 1.0, 1.4, 3.0}) {
        CAPTURE(length_s);
        const CalibratedDrive made =
            calibrated_drive(tone(150.0, 0.9, length_s), calibration, true);
        const double rms = loudest_second(made.drive, true);
        CHECK(std::abs(made.rms - rms) <= 1e-6);
        CHECK(made.drive.largest_level * rms <= 0.1 + 1e-6);
        // Nor is more taken away than has to be.
        CHECK(made.drive.largest_level * rms >= 0.099);
    }
}

TEST_CASE("limits: a tone has the rms of one second of it, a short one that of its repetition") {
    Calibration calibration = flat();
    calibration.rms_limit = 0.1;
    for (const double length_s : {0.3, 1.0, 3.0, 8.0}) {
        CAPTURE(length_s);
        const CalibratedDrive made = calibrated_drive(tone(150.0, 0.5, length_s), calibration);
        CHECK(std::abs(made.rms - loudest_second(made.drive, length_s < 1.0)) <= 1e-6);
        CHECK(made.rms <= 0.5 / std::numbers::sqrt2 + 1e-3);
    }
}

TEST_CASE("limits: excursion is held down to the lowest frequency of the table") {
    Calibration calibration = flat();
    calibration.excursion_limit_mm = 0.5;
    for (const bool loop : {false, true}) {
        for (const double f_hz : {3.0, 6.0, 8.0, 9.9, 12.0, 20.0}) {
            CAPTURE(loop);
            CAPTURE(f_hz);
            const CalibratedDrive made = calibrated_drive(tone(f_hz, 0.4, 3.0), calibration, loop);
            // The excursion of a sine of 0.4 g on an actuator of 1 g per full scale.
            const double omega = 2.0 * std::numbers::pi * f_hz;
            const double moved_mm = 1e3 * 0.4 * 9.80665 / (omega * omega);
            CHECK(made.excursion_mm >= 0.99 * moved_mm);
            CHECK(made.drive.largest_level * moved_mm <= 0.5 * 1.01);
        }
    }
}

TEST_CASE("limits: no frequency goes out stronger than it was measured, at any level") {
    Calibration calibration = flat();
    for (ResponsePoint& point : calibration.points) point.largest_drive = 0.3;
    for (const double amplitude_g : {0.2, 0.31, 0.7, 1.0}) {
        CAPTURE(amplitude_g);
        const CalibratedDrive made = calibrated_drive(tone(100.0, amplitude_g, 1.0), calibration);
        CHECK(made.drive.largest_level * amplitude_g <= 0.3 * 1.02);
        CHECK((amplitude_g > 0.3) == (made.drive.largest_level < 1.0));
    }
}

TEST_CASE("limits: below the table an actuator is driven no harder than its slope allows") {
    Calibration calibration;
    // Falling with frequency there, as above a resonance that was not measured.
    calibration.points = {{50.0, 1.6}, {63.0, 0.8}, {80.0, 0.4}, {200.0, 0.4}};
    const auto strongest = [&](double f_hz) {
        const CalibratedDrive made = calibrated_drive(tone(f_hz, 0.2, 2.0), calibration);
        return *std::ranges::max_element(made.drive.samples);
    };
    CHECK(strongest(45.0) < strongest(50.0));
    CHECK(strongest(41.0) < strongest(45.0));
    // Rising: the lowest point's strength holds, as before.
    calibration.points = {{50.0, 0.4}, {100.0, 1.6}, {200.0, 0.8}};
    CHECK(*response_g(calibration, 40.0) == 0.4);
}

TEST_CASE("limits: a minute is the longest where nothing knows the heat, and --longest holds") {
    Calibration calibration = flat();
    const Waveform waveform = tone(150.0, 0.1, 0.5);
    CHECK(calibrated_drive(waveform, calibration, true).drive.longest_s == kLongestOnEndS);
    calibration.excursion_limit_mm = 0.5;  // of no help against heat
    CHECK(calibrated_drive(waveform, calibration, true).drive.longest_s == kLongestOnEndS);
    CHECK(calibrated_drive(waveform, calibration, true, 1.0).drive.longest_s == 1.0);
    calibration.rms_limit = 0.4;
    CHECK(calibrated_drive(waveform, calibration, true).drive.longest_s ==
          std::numeric_limits<double>::infinity());
    CHECK(calibrated_drive(waveform, calibration, true, 1.0).drive.longest_s == 1.0);
    // Also where the protection is off.
    Drive drive;
    drive.samples.assign(1000, 0.1);
    CHECK(protected_drive(drive, true, false, 1.0).drive.longest_s == 1.0);
    CHECK(protected_drive(drive, true, false).drive.longest_s ==
          std::numeric_limits<double>::infinity());
}

TEST_CASE("limits: a largest drive of 0 is refused, as it would have meant none") {
    Calibration calibration = flat();
    calibration.points[2].largest_drive = 0.0;
    const auto read = parse_calibration(print_calibration(calibration), "c.json");
    REQUIRE_FALSE(read);
    CHECK(read.error().message.find("/points/2/largest_drive: expected a number above 0") !=
          std::string::npos);
}

TEST_CASE("limits: a short push keeps nothing of its slow motion") {
    for (const double length_s : {0.006, 0.03, 0.1}) {
        CAPTURE(length_s);
        Drive push;
        const auto count = static_cast<std::size_t>(length_s * push.rate_hz);
        for (std::size_t n = 0; n < count; ++n) {
            push.samples.push_back(
                std::sin(std::numbers::pi * static_cast<double>(n) / static_cast<double>(count)));
        }
        const Drive kept = protected_drive(push, false, true).drive;
        // The amplitude at 5 Hz: the sum against a cosine and a sine.
        const auto at_5_hz = [](const Drive& drive) {
            double re = 0.0;
            double im = 0.0;
            for (std::size_t n = 0; n < drive.samples.size(); ++n) {
                const double angle =
                    2.0 * std::numbers::pi * 5.0 * static_cast<double>(n) / drive.rate_hz;
                re += drive.samples[n] * std::cos(angle);
                im += drive.samples[n] * std::sin(angle);
            }
            return std::hypot(re, im);
        };
        CHECK(at_5_hz(kept) < 0.1 * at_5_hz(push));  // 20 dB at least
        CHECK(kept.samples.size() >= push.samples.size());
    }
}

}  // namespace limits_test
