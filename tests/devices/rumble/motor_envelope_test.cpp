#include "devices/rumble/motor_envelope.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "devices/rumble/rumble_plan.h"
#include "model/signal/waveform.h"

namespace motor_envelope_test {

using namespace tact;

namespace {

constexpr double kHopS = 0.015;

Drive tone(double frequency_hz, double amplitude, double from_s, double to_s, double length_s) {
    Drive drive;
    drive.samples.resize(sample_count(length_s, kModelRateHz));
    for (std::size_t n = 0; n < drive.samples.size(); ++n) {
        const double t_s = static_cast<double>(n) / kModelRateHz;
        if (t_s < from_s || t_s >= to_s) continue;
        drive.samples[n] = amplitude * std::sin(2.0 * std::numbers::pi * frequency_hz * t_s);
    }
    return drive;
}

std::vector<RumbleFrame> frames_of(const Drive& drive) {
    return motor_pair_frames(motor_pair_strengths(drive, kHopS), kHopS, 1.0);
}

// A motor's strength after a second of a steady envelope.
double strength_after_a_second(const Motor& motor, double envelope, double level) {
    double speed = 0.0;
    for (const double duty : motor_duties(motor, std::vector<double>(70, envelope), kHopS, level)) {
        speed = speed_after(motor, speed, duty, kHopS);
    }
    return speed * speed;
}

}  // namespace

TEST_CASE("motors: the envelope of a steady sine is its amplitude") {
    const Drive drive = tone(150.0, 0.6, 0.0, 1.0, 1.0);
    const auto strengths = envelope(drive.samples, drive.rate_hz, kHopS);
    REQUIRE(strengths.size() == 67);
    for (std::size_t k = 3; k + 3 < strengths.size(); ++k) {
        CHECK(std::abs(strengths[k] - 0.6) <= 0.012);
    }
}

TEST_CASE("motors: low tones are the strong motor's, high ones the weak one's") {
    const auto low = frames_of(tone(40.0, 0.8, 0.0, 0.6, 0.6));
    const auto high = frames_of(tone(300.0, 0.8, 0.0, 0.6, 0.6));
    CHECK(low[20].low > 0.8);
    CHECK(low[20].high == 0.0);
    CHECK(high[20].low == 0.0);
    CHECK(high[20].high > 0.8);
}

TEST_CASE("motors: after it has come up to speed a motor's strength is the envelope") {
    for (const Motor& motor : {kStrongMotor, kWeakMotor}) {
        for (const double strength : {0.05, 0.3, 0.7, 1.0}) {
            const std::vector<double> steady(80, strength);
            double speed = 0.0;
            for (const double duty : motor_duties(motor, steady, kHopS)) {
                CHECK(duty >= 0.0);
                CHECK(duty <= 1.0);
                speed = speed_after(motor, speed, duty, kHopS);
            }
            CHECK(std::abs(speed * speed - strength) <= 0.01 * strength);
        }
    }
}

TEST_CASE("motors: strength is in proportion to the level, and moves at every one") {
    for (const Motor& motor : {kStrongMotor, kWeakMotor}) {
        for (const double level : {0.01, 0.1, 0.3, 1.0}) {
            for (const double strength : {0.03, 0.3, 1.0}) {
                CAPTURE(level);
                const double felt = strength_after_a_second(motor, strength, level);
                CHECK(felt > 0.0);
                CHECK(std::abs(felt - level * strength) <= 0.01 * level * strength);
            }
        }
        // What is beyond full scale is not, where it is turned down.
        CHECK(std::abs(strength_after_a_second(motor, 4.0, 0.1) - 0.4) <= 0.004);
        CHECK(strength_after_a_second(motor, 1.0, 0.0) == 0.0);
    }
    Drive strong = tone(150.0, 3.0, 0.0, 1.0, 1.0);
    const Strengths strengths = intensity_strengths(strong, kHopS);
    CHECK(std::abs(intensity_frames(strengths, 0.1)[30].low - 0.3) <= 0.006);
    CHECK(intensity_frames(strengths, 1.0)[30].low == 1.0);
}

TEST_CASE("motors: a tone half an octave from the split drives one motor alone") {
    for (const double frequency_hz : {30.0, 60.0, 75.0}) {
        CAPTURE(frequency_hz);
        for (std::size_t k = 10; k < 30; ++k) {
            const RumbleFrame frame = frames_of(tone(frequency_hz, 1.0, 0.0, 0.6, 0.6))[k];
            CHECK(frame.high == 0.0);
            CHECK(frame.low > 0.8);
        }
    }
    for (const double frequency_hz : {160.0, 250.0, 400.0}) {
        CAPTURE(frequency_hz);
        for (std::size_t k = 10; k < 30; ++k) {
            const RumbleFrame frame = frames_of(tone(frequency_hz, 1.0, 0.0, 0.6, 0.6))[k];
            CHECK(frame.low == 0.0);
            CHECK(frame.high > 0.8);
        }
    }
    // At the split both, and two tones are two.
    const RumbleFrame between = frames_of(tone(110.0, 1.0, 0.0, 0.6, 0.6))[20];
    CHECK(between.low > 0.5);
    CHECK(between.high > 0.5);
    Drive both = tone(50.0, 0.5, 0.0, 0.6, 0.6);
    const Drive other = tone(250.0, 0.5, 0.0, 0.6, 0.6);
    for (std::size_t n = 0; n < both.samples.size(); ++n) both.samples[n] += other.samples[n];
    const Strengths strengths = motor_pair_strengths(both, kHopS);
    // The filters pass 96 %, and a quarter of the other takes 3 % of that.
    CHECK(std::abs(strengths.low[20] - 0.5) <= 0.04);
    CHECK(std::abs(strengths.high[20] - 0.5) <= 0.04);
}

TEST_CASE("motors: full duty brings a motor up sooner than its steady duty would") {
    const std::vector<double> step(20, 0.25);
    const auto duties = motor_duties(kStrongMotor, step, kHopS);
    CHECK(duties[0] == 1.0);
    double driven = 0.0;
    double waited = 0.0;
    const double steady = duties.back();
    for (std::size_t k = 0; k < 3; ++k) {
        driven = speed_after(kStrongMotor, driven, duties[k], kHopS);
        waited = speed_after(kStrongMotor, waited, steady, kHopS);
    }
    CHECK(driven > 0.45);
    CHECK(waited < 0.3);
    // And never longer than 40 ms beyond what the envelope asks for, in hops of 15 ms.
    CHECK(std::ranges::count_if(duties, [&](double d) { return d > steady + 1e-9; }) <= 3);
}

TEST_CASE("motors: an envelope that falls brakes by no duty at all, and silence stays silent") {
    std::vector<double> falling(20, 1.0);
    falling.resize(40, 0.2);
    const auto duties = motor_duties(kStrongMotor, falling, kHopS);
    CHECK(duties[20] == 0.0);
    for (const double duty : motor_duties(kStrongMotor, std::vector<double>(10, 0.0), kHopS)) {
        CHECK(duty == 0.0);
    }
    CHECK(frames_of(Drive{}).empty());
}

TEST_CASE("motors: a faint end does not flutter on and off") {
    Drive drive = tone(150.0, 0.04, 0.0, 1.0, 1.0);
    for (const RumbleFrame& frame : intensity_frames(intensity_strengths(drive, kHopS), 1.0))
        CHECK(frame.low == 0.0);
    // The same faintness continues if it follows something stronger.
    for (std::size_t n = 0; n < 3000; ++n) drive.samples[n] *= 10.0;
    const auto frames = intensity_frames(intensity_strengths(drive, kHopS), 1.0);
    CHECK(frames[10].low > 0.35);
    for (std::size_t k = 30; k < 60; ++k) CHECK(std::abs(frames[k].low - 0.04) < 0.005);
}

TEST_CASE("motors: what is split off below an edge is not delayed") {
    const Drive drive = tone(30.0, 1.0, 0.3, 0.7, 1.0);
    const auto low = below(drive.samples, kMotorSplitHz, drive.rate_hz);
    double same = 0.0;
    double later = 0.0;
    for (std::size_t n = 4000; n < 6000; ++n) {
        same = std::max(same, std::abs(low[n] - drive.samples[n]));
        later = std::max(later, std::abs(low[n] - drive.samples[n - 10]));
    }
    CHECK(same < 0.02);
    CHECK(later > 0.15);
}

TEST_CASE("rumble plan: a sample that is no number, or none that is finite, is silence") {
    const double none[] = {std::numeric_limits<double>::quiet_NaN(),
                           std::numeric_limits<double>::infinity(),
                           -std::numeric_limits<double>::infinity()};
    for (const double sample : none) {
        const RumblePlan plan(Drive{kModelRateHz, std::vector<double>(500, sample)},
                              Language::motor_pair, 0.015);
        CHECK(std::ranges::all_of(plan.drive().samples, [](double x) { return x == 0.0; }));
    }
}

}  // namespace motor_envelope_test
