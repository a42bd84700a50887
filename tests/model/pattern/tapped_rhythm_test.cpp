#include "model/pattern/tapped_rhythm.h"

#include <doctest/doctest.h>

#include <string>
#include <vector>

#include "model/common/random.h"

namespace tapped_rhythm_test {

using namespace tact;

namespace {

// As a hand taps a rhythm: each note let go a little before its end, none where it should be.
std::vector<Tap> tapped(const Rhythm& rhythm, double held, double jitter_s, RandomStream& random) {
    std::vector<Tap> taps;
    const double once_s = static_cast<double>(rhythm.text.size()) * rhythm.unit_s;
    for (const Note& note : notes(rhythm, once_s)) {
        const double onset_s = 1.7 + note.onset_s + jitter_s * next_normal(random);
        taps.push_back({onset_s, note.length_s - (1.0 - held) * rhythm.unit_s});
    }
    return taps;
}

std::string taken(const std::vector<Tap>& taps) {
    return tapped_rhythm(taps, estimated_step_s(taps), 0.0).rhythm.text;
}

}  // namespace

TEST_CASE("tapped rhythm: what is tapped exactly is the rhythm, at any tempo") {
    RandomStream random{1};
    for (const std::string text : {"x=--x-x", "x-x-x-x", "x--x--x-x=", "x===--x=--x-x"}) {
        for (const double unit_s : {0.05, 0.125, 0.4}) {
            const std::vector<Tap> taps = tapped({text, unit_s}, 0.9, 0.0, random);
            CHECK_MESSAGE(taken(taps) == text, text << " at " << unit_s);
            CHECK(estimated_step_s(taps) == doctest::Approx(unit_s).epsilon(1e-9));
        }
    }
}

TEST_CASE("tapped rhythm: a hand that is off by a tenth of a step is still understood") {
    RandomStream random{2};
    int understood = 0;
    constexpr int kRuns = 200;
    for (int run = 0; run < kRuns; ++run) {
        const std::string text = run % 2 == 0 ? "x=--x-x-x=-x-x=" : "x--x--x-x--x--x-x";
        const std::vector<Tap> taps = tapped({text, 0.15}, 0.8, 0.012, random);
        understood += taken(taps) == text;
    }
    CHECK(understood >= 0.9 * kRuns);
}

TEST_CASE("tapped rhythm: even short taps keep rests between them") {
    std::vector<Tap> taps;
    for (int k = 0; k < 5; ++k) taps.push_back({0.5 * k, 0.08});
    const double step_s = estimated_step_s(taps);
    CHECK(step_s == doctest::Approx(0.125));
    CHECK(taken(taps) == "x---x---x---x---x");
}

TEST_CASE("tapped rhythm: another step quantises the same taps again") {
    const std::vector<Tap> taps{{2.0, 0.2}, {2.5, 0.45}, {3.0, 0.1}};
    CHECK(tapped_rhythm(taps, 0.25, 0.0).rhythm.text == "x-x=x");
    CHECK(tapped_rhythm(taps, 0.5, 0.0).rhythm.text == "xxx");
    CHECK(tapped_rhythm(taps, 0.1, 0.0).rhythm.text == "x=---x===-x");
    CHECK(tapped_rhythm(taps, 0.1, 0.0).length_s == doctest::Approx(1.1));
}

TEST_CASE("tapped rhythm: rests fill the pattern, but a text is never too long") {
    const std::vector<Tap> taps{{2.0, 0.1}, {2.4, 0.1}};
    CHECK(tapped_rhythm(taps, 0.1, 1.0).rhythm.text == "x---x-----");
    CHECK(tapped_rhythm(taps, 0.1, 60.0).rhythm.text.size() == 600);
    CHECK(tapped_rhythm(taps, 0.001, 60.0).rhythm.text.size() == 500);
    const std::vector<Tap> late{{0.0, 0.1}, {1.0, 40.0}, {60.0, 0.1}};
    const TappedRhythm cut = tapped_rhythm(late, 0.001, 0.0);
    CHECK(cut.rhythm.text.size() == kMaxRhythmSteps);
    CHECK(cut.left_out == 1);
    CHECK(rhythm_fault(cut.rhythm.text).empty());
}

TEST_CASE("tapped rhythm: the error is what the onsets are off the grid") {
    const std::vector<Tap> taps{{0.0, 0.1}, {0.52, 0.1}, {1.0, 0.1}, {1.52, 0.1}};
    CHECK(tapped_rhythm(taps, 0.5, 0.0).rms_error_s == doctest::Approx(0.01));
    CHECK(tapped_rhythm({}, 0.5, 1.0).rhythm.text.empty());
    CHECK(estimated_step_s({}) == 0.125);
}

}  // namespace tapped_rhythm_test
