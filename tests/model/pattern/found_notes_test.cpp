// Notes found in curves: the same vibration, and none where a rhythm could not say it.
#include <doctest/doctest.h>

#include <cmath>
#include <random>

#include "model/pattern/pattern.h"

namespace found_notes_test {

using namespace tact;

namespace {

Pattern drawn(AmplitudeCurve amplitude, FrequencyCurve frequency, double duration_s) {
    Pattern pattern;
    pattern.amplitude_curve = std::move(amplitude);
    pattern.frequency_curve = std::move(frequency);
    pattern.duration_s = duration_s;
    return pattern;
}

}  // namespace

TEST_CASE(
    "found notes: flat pieces on a grid are notes, to the last bit where one frequency sounds") {
    const Pattern pattern = drawn(
        {{0.0, 1.0}, {0.05, 1.0}, {0.05, 0.0}, {0.1, 0.0}, {0.1, 0.4}, {0.15, 0.4}, {0.15, 0.0}},
        {}, 0.2);
    const auto found = with_found_notes(pattern);
    REQUIRE(found);
    CHECK(found->rhythm.text == "x-A-");
    CHECK(found->rhythm.unit_s == 0.05);
    CHECK(kind_of(found->rhythm, 'A') == NoteKind{0.4, 1.0});
    CHECK(found->amplitude_curve.empty());
    CHECK(render(*found).samples_g == render(pattern).samples_g);
}

TEST_CASE(
    "found notes: random staircases of one frequency are rendered bit by bit as their notes") {
    std::mt19937 random(7);
    for (int round = 0; round < 200; ++round) {
        // Whole ms, as sums of seconds are not where samples are.
        const auto unit_ms = static_cast<double>(1 + random() % 40);
        const std::size_t steps = 3 + random() % 60;
        Pattern pattern = drawn({}, {}, static_cast<double>(steps) * unit_ms / 1000.0);
        pattern.carriers = {{90.0, 1.0, 0.2}, {133.0, 0.5, 0.0}};
        double height = 0.0;
        for (std::size_t k = 0; k < steps; ++k) {
            const double next = static_cast<double>(random() % 4) / 3.0;
            const double at_s = static_cast<double>(k) * unit_ms / 1000.0;
            if (k > 0 && next != height) pattern.amplitude_curve.push_back({at_s, height});
            if (k == 0 || next != height) pattern.amplitude_curve.push_back({at_s, next});
            height = next;
        }
        const auto found = with_found_notes(pattern);
        if (!found) continue;  // silence, or one note throughout
        CAPTURE(found->rhythm.text);
        const auto notes = render(*found).samples_g;
        const auto curves = render(pattern).samples_g;
        REQUIRE(notes.size() == curves.size());
        for (std::size_t n = 0; n < notes.size(); ++n)
            REQUIRE(std::abs(notes[n] - curves[n]) < 1e-12);
    }
}

TEST_CASE(
    "found notes: a frequency of its own is a pitch, and what it does in silence does not count") {
    const Pattern pattern = drawn({{0.0, 1.0}, {0.1, 1.0}, {0.1, 0.0}, {0.2, 0.0}, {0.2, 1.0}},
                                  {{0.0, 100.0}, {0.1, 100.0}, {0.2, 150.0}}, 0.3);
    const auto found = with_found_notes(pattern);
    REQUIRE(found);
    CHECK(found->rhythm.text == "x-A");
    CHECK(kind_of(found->rhythm, 'A').pitch == 1.5);
    CHECK(found->carriers[0].frequency_hz == 100.0);
    CHECK(first_carrier_hz(*found, 0.05) == 100.0);
    CHECK(first_carrier_hz(*found, 0.25) == 150.0);
}

TEST_CASE("found notes: none of a slope, off the grid, of one note throughout, beside a rhythm") {
    CHECK_FALSE(with_found_notes(drawn({{0.0, 1.0}, {0.1, 0.5}}, {}, 0.2)));
    CHECK_FALSE(with_found_notes(
        drawn({{0.0, 1.0}, {0.1, 1.0}, {0.1, 0.0}}, {{0.0, 100.0}, {0.1, 150.0}}, 0.2)));
    CHECK_FALSE(with_found_notes(drawn({{0.0, 1.0}, {0.0123456, 1.0}, {0.0123456, 0.0}}, {}, 0.2)));
    CHECK_FALSE(with_found_notes(drawn({{0.0, 1.0}, {0.0, 1.0}}, {}, 0.2)));
    CHECK_FALSE(with_found_notes(drawn({{0.0, 0.0}}, {}, 0.2)));
    CHECK_FALSE(with_found_notes(Pattern{}));
    Pattern rhythm = drawn({{0.0, 1.0}, {0.1, 1.0}, {0.1, 0.0}}, {}, 0.2);
    CHECK(with_found_notes(rhythm));
    rhythm.rhythm.text = "x-";
    CHECK_FALSE(with_found_notes(rhythm));
    // More strengths than letters stay a curve.
    AmplitudeCurve stairs;
    for (int k = 0; k < 30; ++k) {
        const double value = 0.011 + 0.03 * k;
        stairs.push_back({0.01 * k, value});
        stairs.push_back({0.01 * (k + 1), value});
    }
    CHECK_FALSE(with_found_notes(drawn(stairs, {}, 0.3)));
}

}  // namespace found_notes_test
