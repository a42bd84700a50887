// Heat, by the samples that leave the stream in more than a minute of loops and of plays in turn:
// what a calibration knows of it holds all the time, what nobody knows ends after a minute of
// driving, and what a person says ends when that says so.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "devices/calibration/calibration.h"
#include "devices/device/protection.h"
#include "tests/support/one_channel.h"

namespace heat_test {

using namespace tact;

namespace {

constexpr double kRateHz = 2000.0;
constexpr double kFadeS = 0.02;  // at the end of what ends by itself, and a block

Calibration flat(double rms_limit) {
    Calibration calibration;
    calibration.points = {{20.0, 1.0}, {100.0, 1.0}, {500.0, 1.0}};
    calibration.rms_limit = rms_limit;
    return calibration;
}

// 0.1 of full scale, rms 0.0707.
Waveform tone(double duration_s) {
    Waveform made{kModelRateHz, std::vector<double>(sample_count(duration_s, kModelRateHz))};
    for (std::size_t n = 0; n < made.samples_g.size(); ++n) {
        const double t_s = static_cast<double>(n) / kModelRateHz;
        made.samples_g[n] = 0.1 * std::sin(2.0 * std::numbers::pi * 100.0 * t_s);
    }
    return made;
}

// Blocks of 5 ms.
struct Out : one_channel::Out {
    Out() : one_channel::Out(kRateHz, 10) {}

    static bool is_sound(float sample) { return std::abs(sample) > 1e-4F; }
    double first_sound_s() const {
        return static_cast<double>(std::ranges::find_if(left, is_sound) - left.begin()) / rate_hz;
    }
    double last_sound_s() const {
        std::size_t last = 0;
        for (std::size_t n = 0; n < left.size(); ++n) {
            if (is_sound(left[n])) last = n;
        }
        return static_cast<double>(last) / rate_hz;
    }
    double sounds_s() const { return last_sound_s() - first_sound_s(); }
    // Rms of the loudest second.
    double rms() const {
        const auto window = static_cast<std::size_t>(rate_hz);
        double sum = 0.0;
        double most = 0.0;
        for (std::size_t n = 0; n < left.size(); ++n) {
            sum += static_cast<double>(left[n]) * static_cast<double>(left[n]);
            if (n >= window) {
                const auto old = static_cast<double>(left[n - window]);
                sum -= old * old;
            }
            most = std::max(most, sum);
        }
        return std::sqrt(most / rate_hz);
    }
};

}  // namespace

TEST_CASE("heat: a loop of more than a minute keeps to a limit that is known, and does not end") {
    for (const double length_s : {0.1, 0.5, 3.0}) {
        CAPTURE(length_s);
        Out out;
        out.play(calibrated_drive(tone(length_s), flat(0.05), true).drive, true);
        out.run(75.0);
        CHECK(out.rms() <= 0.05 * 1.005);
        CHECK(out.rms() >= 0.05 * 0.98);
        CHECK(out.last_sound_s() > 74.9);
    }
}

TEST_CASE("heat: plays in turn of more than a minute keep to a limit that is known") {
    Out out;
    const Drive drive = calibrated_drive(tone(0.9), flat(0.05)).drive;
    while (static_cast<double>(out.left.size()) < 75.0 * kRateHz) {
        out.play(drive);
        out.run_to_its_end();
        out.run(0.05);
    }
    CHECK(out.rms() <= 0.05 * 1.005);
    CHECK(out.rms() >= 0.05 * 0.9);
    CHECK(out.last_sound_s() > 73.5);
}

TEST_CASE("heat: a loop of which nobody knows the heat ends after a minute, and has to rest") {
    Out out;
    const Drive drive = calibrated_drive(tone(0.5), flat(0.0), true).drive;
    out.play(drive, true);
    out.run(75.0);
    CHECK(std::abs(out.sounds_s() - kLongestOnEndS) < kFadeS);
    // 15 s of rest, 15 s of play.
    out.play(drive, true);
    out.run(75.0);
    CHECK(std::abs(out.last_sound_s() - (75.0 + 15.0)) < 0.3);
}

TEST_CASE("heat: plays in turn of which nobody knows the heat end when a minute is used up") {
    Out out;
    const Drive drive = calibrated_drive(tone(0.9), flat(0.0)).drive;
    // Each drives for 0.9 s or a little more, and rests for 0.3 s: 0.6 s more with each.
    int plays = 0;
    bool is_warm = false;
    while (!is_warm && plays < 200) {
        out.play(drive);
        out.run_to_its_end();
        is_warm = notes_of(out.playback, out.serial).is_warm;
        out.run(0.3);
        ++plays;
    }
    CHECK(is_warm);
    CHECK(plays >= 92);
    CHECK(plays <= 101);
}

TEST_CASE("heat: what a person says is the longest holds, whatever is known of the heat") {
    for (const double rms_limit : {0.0, 0.05}) {
        for (const double longest_s : {2.0, 65.0}) {
            CAPTURE(rms_limit);
            CAPTURE(longest_s);
            Out out;
            out.play(calibrated_drive(tone(0.5), flat(rms_limit), true, longest_s).drive, true);
            out.run(75.0);
            CHECK(std::abs(out.sounds_s() - longest_s) < kFadeS);
        }
    }
}

}  // namespace heat_test
