// How far what came back is from what was meant: laws of the one judge of all exports.
#include "model/export/envelope_error.h"

#include <doctest/doctest.h>

#include <cmath>

#include "model/export/exported_set.h"

namespace envelope_error_test {

using namespace tact;

namespace {

Pattern tone(double amplitude_g, double hz = 150.0) {
    Pattern pattern;
    pattern.amplitude_g = amplitude_g;
    pattern.carriers.front().frequency_hz = hz;
    pattern.duration_s = 0.3;
    return pattern;
}

Pattern with_jump(double at_s) {
    Pattern pattern = tone(0.5);
    pattern.amplitude_curve = {{at_s, 0.0}, {at_s, 1.0}};
    return pattern;
}

Pattern with_taps(std::size_t taps) {
    Pattern pattern = tone(0.0);
    pattern.duration_s = 1.0;
    for (std::size_t k = 0; k < taps; ++k) {
        pattern.transients.push_back({0.1 * static_cast<double>(k), 0.8, 150.0, 0.02});
    }
    return pattern;
}

}  // namespace

TEST_CASE("envelope error: what is the same is off by nothing, and there are no words") {
    for (const Pattern& pattern : {tone(0.5), tone(0.0), with_jump(0.1), with_taps(5)}) {
        const EnvelopeError error = envelope_error(pattern, pattern);
        CHECK(error.error_db == 0.0);
        CHECK_FALSE(is_lossy(error));
        CHECK(words_of(error).empty());
    }
}

TEST_CASE("envelope error: half as strong is 6 dB off, whichever of the two is the stronger") {
    CHECK(envelope_error(tone(0.8), tone(0.4)).error_db ==
          doctest::Approx(20.0 * std::log10(2.0)).epsilon(1e-6));
    CHECK(envelope_error(tone(0.4), tone(0.8)).error_db ==
          doctest::Approx(20.0 * std::log10(2.0)).epsilon(1e-6));
    CHECK(envelope_error(tone(0.5, 100.0), tone(0.5, 120.0)).error_db >=
          20.0 * std::log10(1.2) * 0.999);
}

TEST_CASE("envelope error: phases cost nothing, and neither does what nobody feels") {
    Pattern turned = tone(0.5);
    turned.carriers.front().phase_rad = 1.0;
    CHECK(envelope_error(tone(0.5), turned).error_db < 0.01);
    CHECK(envelope_error(tone(1e-4), tone(0.0)).error_db == 0.0);
    CHECK_FALSE(envelope_error(tone(1e-4), tone(0.0)).is_silenced);
}

TEST_CASE("envelope error: a jump may move by 1 ms, by 5 ms it is off as far as it jumps") {
    CHECK(envelope_error(with_jump(0.1), with_jump(0.101)).error_db < 0.1);
    const EnvelopeError late = envelope_error(with_jump(0.1), with_jump(0.105));
    CHECK(late.error_db > 20.0);
    CHECK(late.at_s == doctest::Approx(0.1));
}

TEST_CASE("envelope error: accents that are left are counted, among those that stand out") {
    Pattern half = with_taps(8);
    for (std::size_t k = 0; k < 5; ++k) half.transients[k].amplitude_g = 0.3;
    const EnvelopeError error = envelope_error(with_taps(8), half);
    CHECK(error.accents == 8);
    CHECK(error.accents_left == 3);
    CHECK(words_of(error).back() == "3 of 8 accents are left");
    // A transient that does not stand out is no accent.
    Pattern over = tone(0.8);
    over.transients = {{0.1, 0.05, 150.0, 0.02}};
    CHECK(envelope_error(over, over).accents == 0);
    // Nor is an accent left where all is as loud.
    Pattern loud = tone(0.8);
    loud.duration_s = 1.0;
    CHECK(envelope_error(with_taps(8), loud).accents_left < 2);
}

TEST_CASE("envelope error: silence is the last word") {
    const EnvelopeError error = envelope_error(with_taps(3), tone(0.0));
    CHECK(error.is_silenced);
    CHECK(words_of(error).back() == kSilenced);
    CHECK(words_of(error).front() == "lasts 300 ms in place of 1000 ms");
    CHECK_FALSE(envelope_error(tone(0.0), tone(0.0)).is_silenced);
}

TEST_CASE("envelope error: a pulse at the beginning is felt, whatever an envelope begins with") {
    for (const double hz : {90.0, 165.0, 240.0}) {
        for (const double length_s : {0.005, 0.012, 0.02, 0.03}) {
            for (const double end_s : {0.0, 0.01, 0.1}) {
                CAPTURE(hz);
                CAPTURE(length_s);
                CAPTURE(end_s);
                Pattern pulse = tone(1.0, hz);
                pulse.duration_s = length_s + end_s;
                if (end_s > 0.0) {
                    pulse.amplitude_curve = {
                        {0.0, 1.0}, {length_s, 1.0}, {length_s, 0.0}, {pulse.duration_s, 0.0}};
                }
                const auto made = exported(pulse, "p", own_target(TargetFormat::android_xml));
                REQUIRE(made.error);
                CHECK_FALSE(made.error->is_silenced);
                CHECK(peak_g(render(std::get<Pattern>(made.back))) > 0.4);
            }
        }
    }
    Pattern tap = tone(0.0);
    tap.transients = {{0.0, 0.9, 165.0, 0.0121, TransientShape::square}};
    const auto made = exported(tap, "p", own_target(TargetFormat::android_xml));
    CHECK_FALSE(made.error->is_silenced);
    CHECK(made.error->accents_left == made.error->accents);
}

}  // namespace envelope_error_test
