#include "devices/device/protection.h"

#include <doctest/doctest.h>

#include <cmath>
#include <complex>
#include <limits>
#include <numbers>

namespace protection_test {

using namespace tact;

namespace {

Drive tone(double frequency_hz, double amplitude, double duration_s) {
    Drive drive;
    const auto count = static_cast<std::size_t>(duration_s * drive.rate_hz);
    for (std::size_t n = 0; n < count; ++n) {
        const double t_s = static_cast<double>(n) / drive.rate_hz;
        drive.samples.push_back(amplitude * std::sin(2.0 * std::numbers::pi * frequency_hz * t_s));
    }
    return drive;
}

double largest(const std::vector<double>& samples) {
    double most = 0.0;
    for (const double sample : samples) most = std::max(most, std::abs(sample));
    return most;
}

// The amplitude at a frequency, away from the ends; of a constant twice as much.
double line(const Drive& drive, double frequency_hz) {
    std::complex<double> sum = 0.0;
    double weight = 0.0;
    const auto count = static_cast<double>(drive.samples.size());
    for (std::size_t n = 0; n < drive.samples.size(); ++n) {
        const double at = (static_cast<double>(n) + 0.5) / count;
        const double hann = 1.0 - std::cos(2.0 * std::numbers::pi * at);
        const double angle =
            2.0 * std::numbers::pi * frequency_hz * static_cast<double>(n) / drive.rate_hz;
        sum += hann * drive.samples[n] * std::polar(1.0, -angle);
        weight += hann;
    }
    return 2.0 * std::abs(sum) / weight;
}

}  // namespace

TEST_CASE("protection: switched off, a drive is what it was to the bit") {
    const Drive slow = tone(1.0, 0.8, 1.0);
    const ProtectedDrive made = protected_drive(slow, false, false);
    CHECK(made.drive == slow);
    CHECK(made.remark.empty());
}

TEST_CASE("protection: a tone of 1 Hz does not reach the coil, one of 20 Hz does as it was") {
    const ProtectedDrive slow = protected_drive(tone(1.0, 0.8, 2.0), false, true);
    CHECK(slow.drive.samples.size() == 20'000);
    CHECK(largest(slow.drive.samples) < 0.1);
    CHECK(slow.remark.find("slower than 16 Hz") != std::string::npos);
    // A constant pull is the slowest there is.
    const Drive constant{kModelRateHz, std::vector<double>(20'000, 0.5)};
    const std::vector<double> kept = protected_drive(constant, false, true).drive.samples;
    CHECK(largest({kept.begin() + 2000, kept.end() - 2000}) < 0.02);
    // Up to its sudden ends, which reach down there: the more, the slower the tone.
    for (const double frequency_hz : {20.0, 47.3, 150.0, 499.9}) {
        CAPTURE(frequency_hz);
        const Drive meant = tone(frequency_hz, 0.8, 1.0);
        const ProtectedDrive made = protected_drive(meant, false, true);
        CHECK(made.remark.empty());
        const double at_ends = 0.8 * 5.0 / frequency_hz;  // 1/4 of the peak at 20 Hz, 3 % at 150
        for (std::size_t n = 50; n + 50 < meant.samples.size(); ++n) {
            const bool is_inside = n >= 2500 && n + 2500 < meant.samples.size();
            REQUIRE(std::abs(made.drive.samples[n] - meant.samples[n]) <
                    (is_inside ? 0.05 * at_ends : at_ends));
        }
        CHECK(protected_drive(tone(frequency_hz, 0.8, 10.0), true, true).remark.empty());
    }
}

TEST_CASE("protection: below 10 Hz no more than a quarter passes, however little of it there is" *
          doctest::test_suite("long")) {
    const double duration_s = 10.0;
    for (const bool loop : {false, true}) {
        for (const double slow_hz : {0.0, 0.5, 1.0, 3.1, 6.0, 8.0, 9.0, 10.0}) {
            for (const double amplitude : {0.4, 0.1, 0.01, 0.001}) {
                CAPTURE(loop);
                CAPTURE(slow_hz);
                CAPTURE(amplitude);
                Drive two = tone(150.0, 0.4, duration_s);
                const Drive slow =
                    slow_hz == 0.0 ? Drive{kModelRateHz, std::vector<double>(100'000, amplitude)}
                                   : tone(slow_hz, amplitude, duration_s);
                for (std::size_t n = 0; n < slow.samples.size(); ++n) {
                    two.samples[n] += slow.samples[n];
                }
                const ProtectedDrive made = protected_drive(two, loop, true);
                CHECK(line(made.drive, slow_hz) <= 0.2501 * line(two, slow_hz));
                CHECK(std::abs(line(made.drive, 150.0) - 0.4) < 1e-4);
                // 0.5 % of the energy is 7 % of the amplitude, and a little more of both at 10 Hz.
                if (amplitude >= 0.1) CHECK_FALSE(made.remark.empty());
                if (amplitude <= 0.01) CHECK(made.remark.empty());
            }
        }
    }
}

TEST_CASE("protection: a loop whose lines all lie above 16 Hz is as it was, seam and all") {
    for (const double frequency_hz : {20.0, 150.0}) {
        const Drive meant = tone(frequency_hz, 0.8, 0.5);
        const std::vector<double> made = protected_drive(meant, true, true).drive.samples;
        for (std::size_t n = 0; n < made.size(); ++n) {
            REQUIRE(std::abs(made[n] - meant.samples[n]) < 1e-12);
        }
    }
}

TEST_CASE("protection: of a mixture the slow part goes, and the fast part stays") {
    Drive mixed = tone(2.0, 0.4, 2.0);
    const Drive fast = tone(150.0, 0.4, 2.0);
    for (std::size_t n = 0; n < fast.samples.size(); ++n) mixed.samples[n] += fast.samples[n];
    const std::vector<double> made = protected_drive(mixed, false, true).drive.samples;
    for (std::size_t n = 5000; n < 15'000; ++n) {
        REQUIRE(std::abs(made[n] - fast.samples[n]) < 0.01);
    }
}

TEST_CASE("protection: both ends take 5 ms, where 1 is 1 already and a loop's seam is its own") {
    Drive sudden = tone(150.0, 0.0, 0.1);
    for (std::size_t n = 0; n < sudden.samples.size(); ++n) {
        sudden.samples[n] = n / 10 % 2 == 0 ? 0.5 : -0.5;  // 500 Hz, full from the first sample on
    }
    const std::vector<double> made = protected_drive(sudden, false, true).drive.samples;
    CHECK(std::abs(made.front()) < 0.001);
    CHECK(std::abs(made.back()) < 0.001);
    CHECK(std::abs(std::abs(made[25]) - 0.25) < 0.02);
    // Each half wave pushes a little, and the slow part of that goes.
    for (std::size_t n = 50; n < 950; ++n) {
        REQUIRE(std::abs(made[n] - sudden.samples[n]) < 0.01);
    }
    const std::vector<double> loop = protected_drive(sudden, true, true).drive.samples;
    for (std::size_t n = 0; n < loop.size(); ++n) {
        REQUIRE(std::abs(loop[n] - sudden.samples[n]) < 1e-12);
    }
}

TEST_CASE("protection: nothing plays on end for longer than it may, and that is said") {
    const ProtectedDrive made = protected_drive(tone(150.0, 0.5, 2.0), false, true, 1.5);
    CHECK(made.drive.longest_s == 1.5);
    CHECK(made.remark.find("after 1.5 s") != std::string::npos);
    CHECK(protected_drive(tone(150.0, 0.5, 1.0), true, true).drive.longest_s == kLongestOnEndS);
}

TEST_CASE("protection: what is no number is silence, and nothing stays nothing") {
    Drive drive = tone(150.0, 0.5, 0.1);
    drive.samples[400] = std::numeric_limits<double>::quiet_NaN();
    drive.samples[401] = -std::numeric_limits<double>::infinity();
    for (const double sample : protected_drive(drive, false, true).drive.samples) {
        REQUIRE(std::abs(sample) <= 0.6);
    }
    CHECK(protected_drive({}, false, true).drive.samples.empty());
    // One sample has the filter's ring beside it.
    CHECK(protected_drive({kModelRateHz, {0.3}}, false, true).drive.lead_s == 0.1);
    const Drive nothing{kModelRateHz, std::vector<double>(500, 0.0)};
    CHECK(protected_drive(nothing, false, true).drive.samples == nothing.samples);
}

TEST_CASE("protection: of a loop whose lines all lie below 7 Hz nothing is left") {
    for (const double frequency_hz : {1.0, 5.0, 6.0, 7.0}) {
        CAPTURE(frequency_hz);
        const Drive meant = tone(frequency_hz, 0.8, 1.0);
        CHECK(largest(protected_drive(meant, true, true).drive.samples) < 1e-9);
    }
}

}  // namespace protection_test
