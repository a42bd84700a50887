#include "model/pattern/pattern.h"

#include <limits>
#include <numbers>

#include "tests/support/golden.h"

namespace pattern_test {

using namespace tact;

TEST_CASE("pattern: an unmodulated carrier is a sine, not Eq. 7's silence") {
    const Waveform tone = render(Pattern{});
    REQUIRE(tone.samples_g.size() == 10'000);
    for (std::size_t n = 0; n < 10'000; n += 37) {
        const double phase = 2.0 * std::numbers::pi * 150.0 * static_cast<double>(n) / 10'000.0;
        CHECK(std::abs(tone.samples_g[n] - std::sin(phase)) <= 1e-12);
    }
}

TEST_CASE("pattern: product modulation of a tone is its two side bands") {
    Pattern pattern;
    pattern.modulation.frequency_hz = 5.0;
    const Waveform beat = render(pattern);
    for (std::size_t n = 0; n < beat.samples_g.size(); n += 41) {
        const double t = 2.0 * std::numbers::pi * static_cast<double>(n) / 10'000.0;
        const double expected = 0.5 * (std::cos(145.0 * t) - std::cos(155.0 * t));
        CHECK(std::abs(beat.samples_g[n] - expected) <= 1e-10);
    }
}

TEST_CASE("pattern: the am kind without depth, or without a frequency, leaves the carrier alone") {
    Pattern pattern;
    pattern.modulation = {ModulationKind::am, 10.0, 0.0};
    CHECK(render(pattern) == render(Pattern{}));
    pattern.modulation = {ModulationKind::am, 0.0, 1.0};
    CHECK(render(pattern) == render(Pattern{}));
}

TEST_CASE("pattern: rests are silent and ramps are linear") {
    Pattern pattern;
    pattern.carriers = {{0.1, 1.0, std::numbers::pi / 2.0}};  // next to constant
    pattern.rhythm = {"x-", 0.1};
    pattern.attack_s = 0.02;
    pattern.release_s = 0.04;
    pattern.duration_s = 0.2;
    const auto samples = render(pattern).samples_g;
    CHECK(samples[0] == 0.0);
    CHECK(std::abs(samples[100] - 0.5) <= 1e-3);  // half way up 20 ms
    CHECK(std::abs(samples[400] - 1.0) <= 1e-3);
    CHECK(std::abs(samples[800] - 0.5) <= 1e-2);  // half way down 40 ms
    CHECK(samples[999] != 0.0);
    CHECK(samples[1000] == 0.0);
    CHECK(samples[1999] == 0.0);
}

TEST_CASE("pattern: a waveform is proportional to its amplitude") {
    Pattern pattern;
    pattern.modulation.frequency_hz = 20.0;
    Pattern twice = pattern;
    twice.amplitude_g = 2.0;
    const auto once = render(pattern).samples_g;
    const auto louder = render(twice).samples_g;
    for (std::size_t n = 0; n < once.size(); n += 13) CHECK(louder[n] == 2.0 * once[n]);
}

TEST_CASE("pattern: clamping moves what is out of range and nothing else") {
    Pattern wild;
    wild.amplitude_g = 1e9;
    wild.carriers.assign(20, Carrier{5000.0, 1.0, 0.0});
    wild.modulation.depth = -3.0;
    wild.duration_s = std::numeric_limits<double>::quiet_NaN();
    const Pattern tame = clamped(wild);
    CHECK(tame.amplitude_g == limits::kAmplitudeG.high);
    CHECK(tame.carriers.size() == limits::kMaxCarriers);
    CHECK(tame.carriers[0].frequency_hz == limits::kCarrierHz.high);
    CHECK(tame.modulation.depth == 0.0);
    CHECK(tame.duration_s == limits::kDurationS.low);
    CHECK(clamped(Pattern{}) == Pattern{});
}

}  // namespace pattern_test
