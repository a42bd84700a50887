#include "devices/rumble/two_band_tracking.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "model/pattern/pattern.h"
#include "tests/support/golden.h"

namespace two_band_tracking_test {

using namespace tact;

namespace {

constexpr double kHopS = 0.015;
constexpr double kTurn = 2.0 * std::numbers::pi;

struct Sine {
    double frequency_hz;
    double amplitude;
};

Drive tones(std::initializer_list<Sine> sines, double duration_s = 0.6) {
    Drive drive;
    drive.samples.resize(sample_count(duration_s, kModelRateHz));
    double phase = 0.4;  // any: not the same for two
    for (const Sine& sine : sines) {
        for (std::size_t n = 0; n < drive.samples.size(); ++n) {
            const double t_s = static_cast<double>(n) / kModelRateHz;
            drive.samples[n] += sine.amplitude * std::sin(kTurn * sine.frequency_hz * t_s + phase);
        }
        phase += 1.7;
    }
    return drive;
}

bool is_near(double got, double expected, double share) {
    return std::abs(got - expected) <= share * expected;
}

// Every frame but those at either end.
void check_steady(const Drive& drive, Sine low, Sine high) {
    const std::size_t frames = frame_count(drive, kHopS);
    for (std::size_t k = 4; k + 4 < frames; ++k) {
        const TrackedFrame frame = tracked_frame(drive, k, kHopS);
        CAPTURE(k);
        CAPTURE(frame.rumble.low_hz);
        CAPTURE(frame.rumble.high_hz);
        CAPTURE(frame.rumble.low);
        CAPTURE(frame.rumble.high);
        CHECK(is_near(frame.rumble.low, low.amplitude, 0.02));
        CHECK(is_near(frame.rumble.high, high.amplitude, 0.02));
        if (low.amplitude > 0.0) CHECK(is_near(frame.rumble.low_hz, low.frequency_hz, 0.01));
        if (high.amplitude > 0.0) CHECK(is_near(frame.rumble.high_hz, high.frequency_hz, 0.01));
        CHECK(frame.share_lost <= 1e-3);
        CHECK_FALSE(frame.noise);
        CHECK_FALSE(frame.folded);
    }
}

// The largest errors of a list of single-tone frames against a truth at each frame's middle.
struct Worst {
    double frequency = 0.0;
    double amplitude = 0.0;
};

Drive chirp(double from_hz, double to_hz) {
    Drive drive;
    for (std::size_t n = 0; n < 10'000; ++n) {
        const double t_s = static_cast<double>(n) / kModelRateHz;
        drive.samples.push_back(
            0.8 * std::sin(kTurn * (from_hz * t_s + (to_hz - from_hz) * t_s * t_s / 2.0)));
    }
    return drive;
}

}  // namespace

TEST_CASE("tracking: two tones become the two bands, to 1 % and 2 %") {
    check_steady(tones({{80.0, 0.6}, {250.0, 0.3}}), {80.0, 0.6}, {250.0, 0.3});
    check_steady(tones({{45.0, 0.5}, {400.0, 0.4}}), {45.0, 0.5}, {400.0, 0.4});
    check_steady(tones({{90.0, 0.1}, {600.0, 0.8}}), {90.0, 0.1}, {600.0, 0.8});
}

TEST_CASE("tracking: one tone goes to the band it is at home in, the other stays silent") {
    check_steady(tones({{150.0, 0.9}}), {150.0, 0.9}, {0.0, 0.0});
    check_steady(tones({{250.0, 0.9}}), {0.0, 0.0}, {250.0, 0.9});
}

TEST_CASE("tracking: 150 Hz switched 40 times a second is 110 and 190 Hz") {
    Pattern pattern;
    pattern.amplitude_g = 0.9;
    pattern.modulation = {ModulationKind::product, 40.0, 1.0};
    const Drive drive{kModelRateHz, render(pattern).samples_g};
    check_steady(drive, {110.0, 0.45}, {190.0, 0.45});
}

TEST_CASE("tracking: of a carrier with two sidebands one sideband is lost, and told") {
    Pattern pattern;
    pattern.amplitude_g = 0.5;
    pattern.modulation = {ModulationKind::am, 40.0, 0.8};
    const Drive drive{kModelRateHz, render(pattern).samples_g};
    // 0.5 at 150 Hz and 0.2 at 110 and 190 Hz: the share of one sideband's energy.
    const double lost = 0.04 / (0.25 + 2.0 * 0.04);
    for (std::size_t k = 4; k + 4 < frame_count(drive, kHopS); ++k) {
        const TrackedFrame frame = tracked_frame(drive, k, kHopS);
        const bool lower = frame.rumble.high_hz < 160.0;
        CHECK(is_near(lower ? frame.rumble.high_hz : frame.rumble.low_hz, 150.0, 0.01));
        CHECK(is_near(lower ? frame.rumble.high : frame.rumble.low, 0.5, 0.02));
        CHECK(is_near(lower ? frame.rumble.low : frame.rumble.high, 0.2, 0.02));
        CHECK(std::abs(frame.share_lost - lost) <= 0.02);
    }
}

TEST_CASE("tracking: a sweep from 50 to 400 Hz in a second is followed to 1 % and 2 %") {
    const Drive drive = chirp(50.0, 400.0);
    Worst worst;
    for (std::size_t k = 2; k + 2 < frame_count(drive, kHopS); ++k) {
        const RumbleFrame frame = tracked_frame(drive, k, kHopS).rumble;
        const double truth_hz = 50.0 + 350.0 * (static_cast<double>(k) + 0.5) * kHopS;
        const bool is_low = frame.low > frame.high;
        CAPTURE(k);
        CHECK(std::min(frame.low, frame.high) == 0.0);
        const double f_hz = is_low ? frame.low_hz : frame.high_hz;
        worst.frequency = std::max(worst.frequency, std::abs(f_hz / truth_hz - 1.0));
        const double a = std::max(frame.low, frame.high);
        worst.amplitude = std::max(worst.amplitude, std::abs(a / 0.8 - 1.0));
    }
    CHECK(worst.frequency <= 0.01);
    CHECK(worst.amplitude <= 0.02);
}

TEST_CASE("tracking: tones 12 Hz apart are told apart, closer ones are one that swells") {
    for (const double apart_hz : {40.0, 25.0, 20.0, 14.0}) {
        CAPTURE(apart_hz);
        check_steady(tones({{100.0, 0.4}, {100.0 + apart_hz, 0.4}}), {100.0, 0.4},
                     {100.0 + apart_hz, 0.4});
    }
    const Drive beating = tones({{150.0, 0.4}, {155.0, 0.4}});
    double faintest = 1.0;
    double loudest = 0.0;
    for (std::size_t k = 4; k + 4 < frame_count(beating, kHopS); ++k) {
        const RumbleFrame frame = tracked_frame(beating, k, kHopS).rumble;
        faintest = std::min(faintest, frame.low + frame.high);
        loudest = std::max(loudest, frame.low + frame.high);
    }
    CHECK(loudest > 0.75);
    CHECK(faintest < 0.15);
}

TEST_CASE("tracking: a tone below the low band plays as swells of 160 Hz, and says so") {
    const Drive drive = tones({{30.0, 0.7}});
    for (std::size_t k = 4; k + 4 < frame_count(drive, kHopS); ++k) {
        const TrackedFrame frame = tracked_frame(drive, k, kHopS);
        CHECK(frame.folded);
        CHECK(frame.rumble.low_hz == 160.0);
        CHECK(frame.rumble.low <= 0.72);
        CHECK(frame.rumble.low >= 0.45);  // within a hop |sin| comes up to sin(45 deg) at least
        CHECK(frame.share_lost > 0.99);
    }
}

TEST_CASE("tracking: noise keeps its level, each band at the middle of its spectrum") {
    Drive drive;
    drive.samples = golden::noise(5, 10'000, 0.3).samples_g;
    // White, of 0.3 / sqrt 3: its bands' levels follow from their widths.
    const double density = 0.09 / 3.0 / (kModelRateHz / 2.0);
    double low = 0.0;
    double high = 0.0;
    const std::size_t frames = frame_count(drive, kHopS);
    for (std::size_t k = 0; k < frames; ++k) {
        const TrackedFrame frame = tracked_frame(drive, k, kHopS);
        CHECK(frame.noise);
        CHECK(frame.rumble.low_hz < 200.0);
        CHECK(frame.rumble.high_hz > 300.0);
        low += frame.rumble.low * frame.rumble.low / static_cast<double>(frames);
        high += frame.rumble.high * frame.rumble.high / static_cast<double>(frames);
    }
    // 1 s of 40 ms looks: 25 x 8 and 25 x 21 independent values, each to 100 %: 7 % and 4 %; x 3.
    CHECK(is_near(low, 2.0 * density * (200.0 - 40.88), 0.25));
    CHECK(is_near(high, 2.0 * density * (626.29 - 200.0), 0.15));
}

TEST_CASE("tracking: notes begin and end with their frames, at full strength") {
    Pattern pattern;
    pattern.rhythm = {"x-x-", 0.06};  // four hops each
    pattern.amplitude_g = 0.8;
    pattern.duration_s = 0.24;
    const Drive drive{kModelRateHz, render(pattern).samples_g};
    for (std::size_t k = 0; k < frame_count(drive, kHopS); ++k) {
        CAPTURE(k);
        const TrackedFrame frame = tracked_frame(drive, k, kHopS);
        const bool sounds = (k / 4) % 2 == 0;
        CHECK(is_near(frame.rumble.low, sounds ? 0.8 : 0.0, 0.02));
        if (sounds) CHECK(is_near(frame.rumble.low_hz, 150.0, 0.01));
    }
}

TEST_CASE("tracking: a click of a few milliseconds plays at its peak, in its frame alone") {
    Drive drive;
    drive.samples.resize(3000);
    for (std::size_t n = 1530; n < 1570; ++n) {
        drive.samples[n] = 0.7 * std::sin(kTurn * 250.0 * static_cast<double>(n) / kModelRateHz);
    }
    for (std::size_t k = 0; k < frame_count(drive, kHopS); ++k) {
        CAPTURE(k);
        const RumbleFrame frame = tracked_frame(drive, k, kHopS).rumble;
        CHECK(is_near(frame.low + frame.high, k == 10 ? 0.7 : 0.0, 0.02));
    }
}

TEST_CASE("tracking: silence is silent, and too strong a signal is held within one coil") {
    const Drive silence{kModelRateHz, std::vector<double>(1000, 0.0)};
    CHECK(frame_count(silence, kHopS) == 7);
    for (std::size_t k = 0; k < 7; ++k) CHECK(tracked_frame(silence, k, kHopS) == TrackedFrame{});
    CHECK(frame_count(Drive{}, kHopS) == 0);
    CHECK(tracked_frame(Drive{}, 0, kHopS) == TrackedFrame{});
    const RumbleFrame loud = tracked_frame(tones({{80.0, 1.2}, {250.0, 0.6}}), 10, kHopS).rumble;
    CHECK(is_near(loud.low, 2.0 / 3.0, 0.02));
    CHECK(is_near(loud.high, 1.0 / 3.0, 0.02));
}

TEST_CASE("tracking: a fade is told down to 3 % of the loudest beside it") {
    for (const double end : {0.03, 0.05, 0.08}) {
        // Loud, 12 ms of a fade, and steady from there on: within one window.
        Drive drive = tones({{150.0, 0.9}}, 0.3);
        for (std::size_t n = 0; n < drive.samples.size(); ++n) {
            const double t_s = static_cast<double>(n) / kModelRateHz - 0.1;
            drive.samples[n] *= std::pow(end, std::clamp(t_s / 0.012, 0.0, 1.0));
        }
        CAPTURE(end);
        const auto middle = static_cast<std::size_t>(0.125 / kHopS);
        const RumbleFrame told = tracked_frame(drive, middle, kHopS).rumble;
        CHECK(std::max(told.low, told.high) > 0.5 * 0.9 * end);
    }
}

}  // namespace two_band_tracking_test
