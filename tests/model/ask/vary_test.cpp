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

TEST_CASE("vary: a thousandth of a step moves no number that a file may hold by more") {
    Pattern pattern;
    pattern.amplitude_g = 0.03;
    pattern.carriers = {{10.0, 1.0}, {900.0, -3.0}};
    pattern.modulation = {ModulationKind::am, 500.0, 0.5};
    pattern.rhythm = {"x-", 5.0};
    pattern.attack_s = 3.0;
    pattern.release_s = 8.0;
    const FeltSteps steps;
    RandomStream random{3};
    for (int k = 0; k < 20; ++k) {
        const Pattern other =
            stepped_at_random(pattern, free_numbers(pattern, {}), steps, 0.001, random);
        for (const PatternParameter parameter : kPatternParameters) {
            CAPTURE(traits(parameter).key);
            CHECK(steps_between(steps, parameter, *value_of(pattern, parameter),
                                *value_of(other, parameter)) <= 0.001 + 1e-9);
        }
    }
}

TEST_CASE("vary: the next is always the one that is farthest from the pattern and all before it") {
    VaryQuestion question = question_of(6.0);
    question.pattern.duration_s = 0.1;
    question.count = 4;
    // Six are drawn for each, from the stream of the seed.
    std::vector<Pattern> pool{question.pattern};
    RandomStream random{question.seed};
    const auto free = free_numbers(question.pattern, {});
    while (pool.size() < 1 + 6 * question.count) {
        pool.push_back(
            stepped_at_random(question.pattern, free, question.steps, question.how_far, random));
    }
    std::vector<Waveform> waveforms;
    for (const Pattern& pattern : pool) waveforms.push_back(render(pattern));
    PredictOptions coarse;
    coarse.envelope_decimation = 10;
    const auto prediction = *predict(waveforms, question.model, coarse);
    const double nc = *std::ranges::max_element(prediction.nc.condensed);
    const double oc = *std::ranges::max_element(prediction.oc.condensed);
    const auto apart = [&](std::size_t i, std::size_t j) {
        return question.model.nc_weight * prediction.nc(i, j) / nc +
               question.model.oc_weight * prediction.oc(i, j) / oc;
    };
    const std::vector<Pattern> given_ones = *varied(question, 0, {});
    std::vector<std::size_t> taken{0};
    for (const Pattern& given : given_ones) {
        std::size_t best = 0;
        double farthest = -1.0;
        for (std::size_t k = 1; k < pool.size(); ++k) {
            double nearest = 1e9;
            for (const std::size_t other : taken) nearest = std::min(nearest, apart(k, other));
            if (nearest <= farthest) continue;
            farthest = nearest;
            best = k;
        }
        CHECK(given == pool[best]);
        taken.push_back(best);
    }
    CHECK(taken.size() == 1 + question.count);
}

}  // namespace vary_test
