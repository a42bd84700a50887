#include "model/pattern/felt_steps.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "model/common/random.h"

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
        CHECK(std::string(traits(parameter).step_source).size() > 3);
        CHECK(step_range(parameter).contains(step_of(felt, parameter)));
    }
    CHECK(traits(PatternParameter::depth).step_is_guess);
    CHECK_FALSE(traits(PatternParameter::carrier).step_is_guess);
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

// Values that a file may hold: the ends, what lies next to them, the bends of the scale, and any.
std::vector<double> legal_values(PatternParameter parameter, RandomStream& random) {
    const ParameterTraits& about = traits(parameter);
    const Range& range = about.range;
    std::vector<double> values{range.low, range.high, std::nextafter(range.low, range.high),
                               std::nextafter(range.high, range.low)};
    for (const double bend :
         {about.first, about.least, 0.5 * about.least, about.slider.low, about.slider.high}) {
        if (range.contains(bend)) values.push_back(bend);
    }
    for (int k = 0; k < 50; ++k) {
        const double share = 0.5 + 0.5 * next_even(random);
        values.push_back(range.low + share * (range.high - range.low));
        const double small = range.high * std::pow(1e-4, share);
        if (range.contains(small)) values.push_back(small);
    }
    return values;
}

// It has every number.
Pattern with_all_numbers() {
    Pattern pattern;
    pattern.carriers.resize(2);
    pattern.modulation = {ModulationKind::am, 8.0, 0.5};
    pattern.rhythm.text = "x-";
    return pattern;
}

TEST_CASE("felt steps: what is within a step stands no more than one apart in every number") {
    const FeltSteps felt;
    RandomStream random{3, 0};
    int within = 0;
    int apart = 0;
    for (const PatternParameter parameter : kPatternParameters) {
        CAPTURE(traits(parameter).key);
        for (const double value : legal_values(parameter, random)) {
            const Pattern a = with_value(with_all_numbers(), parameter, value);
            for (const double count : {0.0, 0.4, 1.0 - 1e-12, 1.0, 1.0 + 1e-12, 1.5, -0.3, -1.0}) {
                const double to = stepped(felt, parameter, value, count);
                const Pattern b = with_value(with_all_numbers(), parameter, to);
                const bool may_be =
                    may_be_within_a_step(places_in_steps(felt, a), places_in_steps(felt, b));
                const bool is_within = within_a_step(felt, a, b);
                CHECK((may_be || !is_within));
                within += is_within ? 1 : 0;
                apart += may_be ? 0 : 1;
            }
        }
    }
    CHECK(within > 1000);
    CHECK(apart > 300);  // those of one step and a half, at least
}

TEST_CASE("felt steps: a step up is more and a step down less, but at the end of what files hold") {
    const FeltSteps felt;
    RandomStream random{5};
    for (const PatternParameter parameter : kPatternParameters) {
        CAPTURE(traits(parameter).key);
        const Range range = traits(parameter).range;
        for (const double value : legal_values(parameter, random)) {
            CAPTURE(value);
            const double up = stepped(felt, parameter, value, 1.0);
            const double down = stepped(felt, parameter, value, -1.0);
            CHECK(stepped(felt, parameter, value, 0.0) == value);
            CHECK(range.contains(up));
            CHECK(range.contains(down));
            CHECK((up > value || value == range.high));
            CHECK((down < value || value == range.low));
            if (up < range.high && up > value && value > 1e-300) {
                CHECK(steps_between(felt, parameter, value, up) == doctest::Approx(1.0));
            }
            double last = value;
            for (int k = 1; k <= 40; ++k) {
                const double next = stepped(felt, parameter, value, k);
                CHECK(next >= last);
                last = next;
            }
        }
    }
}

TEST_CASE("felt steps: a step down of 0.04 g is less than that, and so is one of 0.02 g") {
    const FeltSteps felt;
    for (const double g : {0.04, 0.02, 0.002}) {
        const double down = stepped(felt, PatternParameter::amplitude, g, -1.0);
        CHECK(down == doctest::Approx(g / step_of(felt, PatternParameter::amplitude)));
        CHECK(stepped(felt, PatternParameter::amplitude, down, 1.0) == doctest::Approx(g));
    }
}

TEST_CASE("pattern parameters: what a file may hold is written as it is, and no more than that") {
    RandomStream random{6};
    for (const PatternParameter parameter : kPatternParameters) {
        CAPTURE(traits(parameter).key);
        const Range range = traits(parameter).range;
        for (const double value : legal_values(parameter, random)) {
            const Pattern pattern = with_value(with_all_numbers(), parameter, value);
            CHECK(value_of(pattern, parameter) == value);
            CHECK(clamped(pattern) == pattern);
        }
        // The range is that of files: the next number beside it is moved.
        for (const auto& [end, beside] :
             {std::pair{range.low, range.low - 1e-3}, std::pair{range.high, range.high + 1e-3}}) {
            CHECK(value_of(with_value(with_all_numbers(), parameter, beside), parameter) == end);
        }
        CHECK(range.contains(traits(parameter).slider.low));
        CHECK(range.contains(traits(parameter).slider.high));
    }
}

}  // namespace felt_steps_test
