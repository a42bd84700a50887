#include "model/ask/vary.h"

#include <doctest/doctest.h>

#include <cmath>

namespace vary_test {

using namespace tact;

namespace {

VaryQuestion question_of(double how_far) {
    VaryQuestion question;
    question.pattern.duration_s = 0.2;
    question.pattern.modulation.frequency_hz = 8.0;
    question.how_far = how_far;
    return question;
}

double steps_away(const VaryQuestion& question, const Pattern& other) {
    double squares = 0.0;
    for (const PatternParameter parameter : kPatternParameters) {
        const auto a = value_of(question.pattern, parameter);
        const auto b = value_of(other, parameter);
        REQUIRE(a.has_value() == b.has_value());
        if (!a) continue;
        squares += std::pow(steps_between(question.steps, parameter, *a, *b), 2);
    }
    return std::sqrt(squares);
}

}  // namespace

TEST_CASE("vary: eight others, none farther than asked for, farther where more is asked for") {
    const auto near = varied(question_of(2.0), 0, {});
    const auto far = varied(question_of(8.0), 0, {});
    REQUIRE(near);
    REQUIRE(far);
    CHECK(near->size() == 8);
    double largest = 0.0;
    for (const Pattern& one : *near) {
        CHECK(steps_away(question_of(2.0), one) <= 2.0 + 1e-6);
        CHECK_FALSE(one == question_of(2.0).pattern);
    }
    for (const Pattern& one : *far) largest = std::max(largest, steps_away(question_of(8.0), one));
    CHECK(largest > 4.0);
}

TEST_CASE("vary: the same by its seed on any threads, others by another; locked numbers stay") {
    VaryQuestion question = question_of(4.0);
    CHECK(varied(question, 1, {}) == varied(question, 4, {}));
    const auto first = varied(question, 0, {});
    question.seed = 2;
    CHECK_FALSE(varied(question, 0, {}) == first);
    question.free = {PatternParameter::carrier};
    const auto of_carrier = varied(question, 0, {});
    for (const Pattern& one : *of_carrier) {
        CHECK(one.amplitude_g == question.pattern.amplitude_g);
        CHECK(one.modulation == question.pattern.modulation);
    }
    question.free = {PatternParameter::depth};  // it has none
    CHECK(varied(question, 0, {})->empty());
    std::stop_source stop;
    stop.request_stop();
    CHECK_FALSE(varied(question_of(2.0), 0, stop.get_token()));
}

}  // namespace vary_test
