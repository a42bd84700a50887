#include "model/morph/morph.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "model/pattern/drawn_fault.h"
#include "model/perceptual_model/rhythm_envelope.h"

namespace morph_test {

using namespace tact;

namespace {

Pattern pattern_of(double g, double carrier_hz, double modulation_hz, const char* rhythm) {
    Pattern pattern;
    pattern.amplitude_g = g;
    pattern.carriers[0].frequency_hz = carrier_hz;
    pattern.modulation.frequency_hz = modulation_hz;
    pattern.rhythm.text = rhythm;
    return pattern;
}

double rms_difference(const Pattern& a, const Pattern& b) {
    const Waveform x = render(a);
    const Waveform y = render(b);
    const std::size_t n = std::min(x.samples_g.size(), y.samples_g.size());
    double sum = 0.0;
    for (std::size_t k = 0; k < n; ++k) sum += std::pow(x.samples_g[k] - y.samples_g[k], 2);
    return std::sqrt(sum / static_cast<double>(n));
}

double largest_step(const Pattern& a, const Pattern& b, int parts) {
    double largest = 0.0;
    for (int k = 0; k < parts; ++k) {
        largest = std::max(largest, rms_difference(morphed(a, b, k / double(parts)),
                                                   morphed(a, b, (k + 1) / double(parts))));
    }
    return largest;
}

std::size_t bursts(const Pattern& pattern) {
    EnvelopeParams params;
    const Waveform waveform = render(pattern);
    const std::vector<double> envelope = rhythm_envelope(waveform.samples_g, params);
    std::size_t count = 0;
    bool sounds = false;
    for (const double value : envelope) {
        if (!sounds && value > 0.4) ++count;
        sounds = value > (sounds ? 0.2 : 0.4);
    }
    return count;
}

}  // namespace

TEST_CASE("morph: its ends are the two patterns, bit for bit; between them is no fault") {
    const Pattern a = pattern_of(0.5, 80.0, 0.0, "x--x--x-");
    Pattern b = pattern_of(1.7, 250.0, 20.0, "x=======");
    b.transients = {{0.3, 1.0, 200.0, 0.02}};
    b.amplitude_curve = {{0.1, 0.2}, {0.5, 1.0}, {0.5, 0.3}};
    CHECK(morphed(a, b, 0.0) == a);
    CHECK(morphed(a, b, 1.0) == b);
    for (int k = 1; k < 20; ++k) {
        const Pattern between = morphed(a, b, k / 20.0);
        CHECK_FALSE(drawn_fault(between));
        CHECK(clamped(between) == between);
    }
}

TEST_CASE("morph: numbers go by ratio, one that is 0 by difference") {
    const Pattern half =
        morphed(pattern_of(0.5, 80.0, 0.0, ""), pattern_of(2.0, 320.0, 0.0, ""), 0.5);
    CHECK(half.amplitude_g == doctest::Approx(1.0));
    CHECK(half.carriers[0].frequency_hz == doctest::Approx(160.0));
    const Pattern silent =
        morphed(pattern_of(0.0, 80.0, 0.0, ""), pattern_of(2.0, 80.0, 0.0, ""), 0.5);
    CHECK(silent.amplitude_g == doctest::Approx(1.0));
}

TEST_CASE("morph: no step of the way is far, also into a modulation and between its kinds" *
          doctest::test_suite("long")) {
    Pattern plain = pattern_of(1.0, 150.0, 0.0, "");
    Pattern beats = pattern_of(1.0, 150.0, 10.0, "");
    Pattern am = beats;
    am.modulation.kind = ModulationKind::am;
    am.modulation.depth = 0.7;
    Pattern notes_too = pattern_of(1.0, 150.0, 0.0, "x--x--x-");
    notes_too.attack_s = 0.02;
    CHECK(morph_jumps(plain, beats).empty());
    for (const auto& [a, b] : {std::pair{plain, beats},
                               {beats, am},
                               {plain, am},
                               {plain, notes_too},
                               {notes_too, plain}}) {
        const double whole = rms_difference(a, b);
        CHECK(whole > 0.1);
        CHECK(largest_step(a, b, 200) < 0.12 * whole);
    }
    // The limit of the way is its end, not something near it.
    CHECK(rms_difference(morphed(plain, beats, 1.0 - 1e-6), beats) < 1e-5);
    CHECK(rms_difference(morphed(plain, beats, 1e-6), plain) < 1e-5);
}

TEST_CASE("morph: what cannot change by degrees is named") {
    Pattern low = pattern_of(1.0, 20.0, 0.0, "");
    const Pattern same_hz = pattern_of(1.0, 20.0, 20.0, "");  // a side band of 0 Hz
    REQUIRE(morph_jumps(low, same_hz).size() == 1);
    CHECK(morph_jumps(low, same_hz)[0] == "the modulation");
    CHECK(morphed(low, same_hz, 0.49).modulation == low.modulation);
    CHECK(morphed(low, same_hz, 0.51).modulation == same_hz.modulation);
    low.rhythm = {"x-", 0.002};
    CHECK(morph_jumps(low, same_hz).size() == 2);
}

TEST_CASE("morph: notes that move are as many all the way, none at half strength") {
    const Pattern a = pattern_of(1.0, 200.0, 0.0, "x---x---");
    const Pattern b = pattern_of(1.0, 200.0, 0.0, "x-----x-");
    for (int k = 0; k <= 10; ++k) CHECK(bursts(morphed(a, b, k / 10.0)) == 2);
    const Pattern four = pattern_of(1.0, 200.0, 0.0, "x-x-x-x-");
    CHECK(bursts(morphed(a, four, 0.05)) == 2);
    CHECK(bursts(morphed(a, four, 0.95)) == 4);
}

TEST_CASE("morph: transients in order become each other, more of them fade in") {
    Pattern a = pattern_of(1.0, 200.0, 0.0, "");
    Pattern b = a;
    a.transients = {{0.2, 1.0}};
    b.transients = {{0.8, 2.0}, {0.3, 1.0}};
    const Pattern half = morphed(a, b, 0.5);
    REQUIRE(half.transients.size() == 2);
    CHECK(half.transients[0].time_s == doctest::Approx(0.25));
    CHECK(half.transients[1].amplitude_g == doctest::Approx(1.0));  // half of 2, at its place
    CHECK(half.transients[1].time_s == doctest::Approx(0.8));
}

// How many samples are more than a thousandth apart.
int samples_apart(const Pattern& a, const Pattern& b) {
    const Waveform x = render(a);
    const Waveform y = render(b);
    int count = 0;
    for (std::size_t k = 0; k < std::min(x.samples_g.size(), y.samples_g.size()); ++k) {
        count += std::abs(x.samples_g[k] - y.samples_g[k]) > 1e-3 ? 1 : 0;
    }
    return count;
}

// But for one sample at each edge of a note, which falls on either side of it.
void check_ends(const Pattern& a, const Pattern& b) {
    CHECK(samples_apart(morphed(a, b, 1e-7), a) <= 8);
    CHECK(samples_apart(morphed(a, b, 1.0 - 1e-7), b) <= 8);
}

TEST_CASE("morph: next to an end it is nearly that end, ramps over sloped curves among them") {
    Pattern ramps = pattern_of(1.0, 150.0, 0.0, "x==-x===");
    ramps.attack_s = 0.1;
    ramps.release_s = 0.15;
    ramps.amplitude_curve = {{0.0, 0.1}, {0.2, 1.0}, {0.6, 0.2}, {1.0, 0.9}};
    check_ends(ramps, pattern_of(1.0, 150.0, 0.0, "x-x-x-x-"));
    check_ends(pattern_of(1.0, 150.0, 0.0, ""), ramps);
    Pattern taps = pattern_of(1.0, 150.0, 0.0, "");
    taps.transients = {{0.1, 2.0}, {0.4, 1.0}, {0.7, 1.5}};
    const Pattern none = pattern_of(1.0, 150.0, 0.0, "");
    Pattern one = none;
    one.transients = {{0.5, 1.0}};
    check_ends(taps, none);
    check_ends(none, taps);
    check_ends(taps, one);
    check_ends(one, taps);
    // A modulation faster than its carrier: the lower side band is mirrored at 0 Hz.
    Pattern fast = pattern_of(1.0, 60.0, 90.0, "");
    fast.carriers[0].phase_rad = 0.7;
    check_ends(fast, none);
    check_ends(none, fast);
}

}  // namespace morph_test
