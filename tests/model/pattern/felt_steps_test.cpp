#include "model/pattern/felt_steps.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

namespace felt_steps_test {

using namespace tact;

TEST_CASE("felt steps: they go up and down again, count themselves, and stay in range") {
    const FeltSteps felt;
    for (const PatternParameter parameter : kPatternParameters) {
        CAPTURE(traits(parameter).key);
        const Range range = traits(parameter).range;
        const double middle = std::clamp(1.0, range.low, range.high);
        const double up = stepped(felt, parameter, middle, 1.0);
        CHECK(up >= middle);
        if (up < range.high) {
            CHECK(std::abs(stepped(felt, parameter, up, -1.0) - middle) <= 1e-12);
            CHECK(steps_between(felt, parameter, middle, up) == doctest::Approx(1.0));
            CHECK(steps_between(felt, parameter, up, middle) == doctest::Approx(1.0));
        }
        CHECK(stepped(felt, parameter, middle, 1000.0) == range.high);
        CHECK(stepped(felt, parameter, middle, -1000.0) == range.low);
        CHECK(steps_between(felt, parameter, middle, middle) == 0.0);
    }
    CHECK(stepped(felt, PatternParameter::modulation, 0.0, 1.0) == 1.0);  // off, then 1 Hz
    CHECK(stepped(felt, PatternParameter::modulation, 1.0, -1.0) == 0.0);
    CHECK(steps_between(felt, PatternParameter::modulation, 0.0, 0.5) == 1.0);
    CHECK(steps_between(felt, PatternParameter::modulation, 0.0, 1.2) == doctest::Approx(2.0));
}

TEST_CASE("felt steps: amplitude's is 1.5 dB, a frequency's 20 %, and each names its source") {
    const FeltSteps felt;
    CHECK(20.0 * std::log10(step_of(felt, PatternParameter::amplitude)) == doctest::Approx(1.5));
    CHECK(step_of(felt, PatternParameter::carrier) == 1.2);
    for (const PatternParameter parameter : kPatternParameters) {
        CHECK(std::string(source_of_step(parameter).words).size() > 3);
        CHECK(step_range(parameter).contains(step_of(felt, parameter)));
    }
    CHECK(source_of_step(PatternParameter::depth).is_guess);
    CHECK_FALSE(source_of_step(PatternParameter::carrier).is_guess);
}

TEST_CASE("felt steps: patterns are within a step where no number differs by one") {
    const FeltSteps felt;
    Pattern a;
    Pattern b = a;
    CHECK(within_a_step(felt, a, b));
    b.amplitude_g = 1.1;
    b.carriers[0].frequency_hz = 165.0;
    CHECK(within_a_step(felt, a, b));
    b.amplitude_g = 1.2;
    CHECK_FALSE(within_a_step(felt, a, b));
    b = a;
    b.modulation.frequency_hz = 0.5;  // of nothing, any is felt
    CHECK_FALSE(within_a_step(felt, a, b));
    b = a;
    b.rhythm.text = "x-";
    CHECK_FALSE(within_a_step(felt, a, b));
    b = a;
    b.duration_s = 1.1;
    CHECK(within_a_step(felt, a, b));
    b.duration_s = 1.2;
    CHECK_FALSE(within_a_step(felt, a, b));
    b = a;
    b.carriers.push_back({80.0, 0.1});
    CHECK_FALSE(within_a_step(felt, a, b));
    FeltSteps coarse;
    coarse.size[0] = 2.0;
    b = a;
    b.amplitude_g = 1.9;
    CHECK(within_a_step(coarse, a, b));
}

}  // namespace felt_steps_test
