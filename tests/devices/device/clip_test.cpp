#include "devices/device/clip.h"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "devices/device/drive.h"

namespace clip_test {

using namespace tact;

namespace {

Drive sine(double amplitude, double frequency_hz, std::size_t samples) {
    Drive drive;
    for (std::size_t n = 0; n < samples; ++n) {
        const double t_s = static_cast<double>(n) / drive.rate_hz;
        drive.samples.push_back(amplitude * std::sin(2.0 * std::numbers::pi * frequency_hz * t_s));
    }
    return drive;
}

double sine_at(double frequency_hz, std::ptrdiff_t frame, double rate_hz) {
    return std::sin(2.0 * std::numbers::pi * frequency_hz * static_cast<double>(frame) / rate_hz);
}

}  // namespace

TEST_CASE("clip: at an output's rate a tone is the same tone, 10 ms later") {
    const Clip clip = clip_of(sine(0.5, 150.0, 20'000), 48'000.0, false);
    REQUIRE(clip.samples.size() == 96'000 + 960);
    // Away from the ends, where the filter sees the silence beyond.
    for (std::size_t n = 4800; n < 91'200; ++n) {
        const double expected = 0.5 * sine_at(150.0, static_cast<std::ptrdiff_t>(n) - 480, 48e3);
        REQUIRE(std::abs(static_cast<double>(clip.samples[n]) - expected) < 1e-6);
    }
    CHECK(clip.peak == doctest::Approx(0.5).epsilon(0.01));
}

TEST_CASE("clip: a loop is as long as the signal, and its seam is that of the endless tone") {
    const Clip clip = clip_of(sine(0.5, 150.0, 2000), 48'000.0, true);
    REQUIRE(clip.samples.size() == 9600);
    for (std::ptrdiff_t n = 0; n < 9600; ++n) {
        const double expected = 0.5 * sine_at(150.0, n, 48e3);
        REQUIRE(std::abs(static_cast<double>(clip.samples[static_cast<std::size_t>(n)]) -
                         expected) < 1e-6);
    }
}

TEST_CASE("clip: what is no number is silence, and nothing stays nothing") {
    Drive drive = sine(0.5, 150.0, 1000);
    drive.samples[500] = std::numeric_limits<double>::quiet_NaN();
    drive.samples[501] = std::numeric_limits<double>::infinity();
    for (const float sample : clip_of(drive, 44'100.0, false).samples) {
        REQUIRE(std::isfinite(sample));
    }
    CHECK(clip_of(Drive{}, 48'000.0, true).samples.empty());
    CHECK(clip_of(Drive{10'000.0, {0.3}}, 48'000.0, true).samples.size() == 5);
}

TEST_CASE(
    "drive: full scale is one for all patterns of a set, so that their strengths stay apart") {
    const Waveform weak{10'000.0, {0.0, 0.2, -0.1}};
    const Waveform strong{10'000.0, {0.0, 0.8, -0.4}};
    CHECK(drive_of(weak, 2.0).samples == std::vector<double>{0.0, 0.1, -0.05});
    CHECK(drive_of(strong, 2.0).samples == std::vector<double>{0.0, 0.4, -0.2});
}

TEST_CASE("drive: the test buzz starts and ends softly, and fits full scale") {
    const Drive buzz = test_buzz();
    REQUIRE(buzz.samples.size() == 3000);
    for (const double sample : buzz.samples) REQUIRE(std::abs(sample) <= 1.0);
    CHECK(std::abs(buzz.samples.front()) < 1e-12);
    CHECK(std::abs(buzz.samples.back()) < 0.02);
}

TEST_CASE("clip: its peak is that of the signal, which may lie between two frames") {
    // A quarter of the rate, and never sampled at its top: 0.8 cos(45 degrees) at every frame.
    Drive drive{48'000.0, {}};
    for (int n = 0; n < 4800; ++n) {
        drive.samples.push_back(0.8 * std::sin(std::numbers::pi * (0.5 * n + 0.25)));
    }
    const Clip clip = clip_of(drive, 48'000.0, true);
    CHECK(std::abs(clip.samples[100]) < 0.57F);
    CHECK(std::abs(clip.peak - 0.8F) < 0.005F);
}

}  // namespace clip_test
