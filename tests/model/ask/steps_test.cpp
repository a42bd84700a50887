#include "model/ask/steps.h"

#include <doctest/doctest.h>

#include <cmath>

#include "model/common/random.h"
#include "model/io/set/set_file.h"
#include "model/morph/morph.h"
#include "tests/support/bundled_sets.h"

namespace steps_test {

using namespace tact;

namespace {

Pattern short_pattern(double g, double carrier_hz, double modulation_hz) {
    Pattern pattern;
    pattern.duration_s = 0.2;
    pattern.amplitude_g = g;
    pattern.carriers[0].frequency_hz = carrier_hz;
    pattern.modulation.frequency_hz = modulation_hz;
    return pattern;
}

StepsQuestion question_of(const Pattern& from, const Pattern& to, std::size_t count,
                          StepMeasure measure = StepMeasure::pm) {
    return {from, to, count, measure, {}};
}

// What "predict" says of neighbours in the set of these patterns alone.
Prediction predicted(const std::vector<Pattern>& patterns) {
    PatternSet set;
    for (const Pattern& pattern : patterns) {
        Vibration vibration;
        vibration.source = pattern;
        set.vibrations.push_back(vibration);
    }
    return *predict(model_waveforms(set), set.model);
}

std::vector<double> neighbours(const Dissimilarity& all) {
    std::vector<double> values;
    for (std::size_t k = 0; k + 1 < all.size; ++k) values.push_back(all(k, k + 1));
    return values;
}

// Even by the written set's own prediction, or said not to be, with the place of the jump.
void check_promise(const StepsQuestion& question, const EvenSteps& steps) {
    REQUIRE(steps.patterns.size() == question.count);
    CHECK(steps.patterns.front() == question.from);
    CHECK(steps.patterns.back() == question.to);
    CHECK(std::ranges::is_sorted(steps.shares));
    const Prediction truth = predicted(steps.patterns);
    CHECK(neighbours(truth.pm) == steps.pm);
    if (question.measure != StepMeasure::pm) {
        const auto values = neighbours(question.measure == StepMeasure::nc ? truth.nc : truth.oc);
        for (std::size_t k = 0; k < values.size(); ++k) {
            CHECK(values[k] == doctest::Approx(steps.apart[k]).epsilon(1e-9));
        }
    }
    const double largest_nc = *std::ranges::max_element(truth.nc.condensed);
    const double largest_oc = *std::ranges::max_element(truth.oc.condensed);
    // Patterns of one rhythm have no distance, only the rounding noise of long sums.
    const double oc_weight = largest_oc > 0.01 ? question.model.oc_weight : 0.0;
    if (question.measure == StepMeasure::pm && largest_nc > 0.0 && largest_oc > 0.0) {
        std::vector<double> told;
        for (std::size_t k = 0; k + 1 < truth.nc.size; ++k) {
            told.push_back(question.model.nc_weight * truth.nc(k, k + 1) / largest_nc +
                           oc_weight * truth.oc(k, k + 1) / largest_oc);
            CHECK(told.back() == doctest::Approx(steps.apart[k]).epsilon(1e-9));
        }
        CHECK(unevenness(told) == doctest::Approx(steps.uneven).epsilon(1e-6));
        CHECK((unevenness(told) <= kEvenWithin) == is_even(steps));
    }
    const std::string said = sentence_on(question, steps);
    INFO(said);
    if (is_even(steps)) {
        CHECK(steps.uneven == unevenness(steps.apart));
        CHECK(steps.uneven <= kEvenWithin);
    } else {
        REQUIRE(steps.jump);
        CHECK(steps.jump->distance > 0.0);
        CHECK(said.find("jump") != std::string::npos);
    }
}

}  // namespace

TEST_CASE("steps: between short patterns they are even, or it is said where the way jumps" *
          doctest::test_suite("long")) {
    const Pattern a = short_pattern(0.5, 80.0, 0.0);
    const Pattern b = short_pattern(1.5, 240.0, 12.0);
    for (const StepMeasure measure : {StepMeasure::pm, StepMeasure::nc, StepMeasure::oc}) {
        for (const std::size_t count : {2, 3, 5, 9, 16}) {
            const StepsQuestion question = question_of(a, b, count, measure);
            const auto steps = even_steps(question, {});
            REQUIRE(steps);
            check_promise(question, *steps);
        }
    }
}

TEST_CASE("steps: two alike have none, and that is said") {
    const Pattern a = short_pattern(1.0, 150.0, 0.0);
    const StepsQuestion question = question_of(a, a, 4);
    const auto steps = even_steps(question, {});
    REQUIRE(steps);
    CHECK(steps->ends_apart == 0.0);
    CHECK(sentence_on(question, *steps).find("do not differ") != std::string::npos);
}

TEST_CASE("steps: the same bits for any number of threads; none when stopped") {
    const StepsQuestion question =
        question_of(short_pattern(0.5, 80.0, 0.0), short_pattern(1.0, 200.0, 8.0), 5);
    StepsOptions one;
    one.threads = 1;
    StepsOptions four;
    four.threads = 4;
    const auto a = even_steps(question, one);
    const auto b = even_steps(question, four);
    CHECK(a->shares == b->shares);
    CHECK(a->patterns == b->patterns);
    CHECK(a->pm == b->pm);
    std::stop_source stop;
    stop.request_stop();
    StepsOptions stopped;
    stopped.stop = stop.get_token();
    CHECK_FALSE(even_steps(question, stopped));
}

TEST_CASE("steps: along a number only that number changes") {
    const Pattern a = short_pattern(0.5, 80.0, 0.0);
    const Pattern b = short_pattern(1.5, 240.0, 0.0);
    const auto end = end_along(a, b, PatternParameter::amplitude);
    REQUIRE(end);
    CHECK(end->amplitude_g == 1.5);
    CHECK(end->carriers == a.carriers);
    CHECK_FALSE(end_along(a, b, PatternParameter::second_carrier));
    const auto steps = even_steps(question_of(a, *end, 4), {});
    for (const Pattern& pattern : steps->patterns) {
        CHECK(with_value(pattern, PatternParameter::amplitude, 0.5) == a);
    }
}

TEST_CASE("steps: between pairs of the example sets, the promise is kept" *
          doctest::test_suite("long")) {
    for (const std::string& file : {kAmSet, kTwelve}) {
        const PatternSet set = read_set_file(file)->set;
        RandomStream random{7};
        for (int tried = 0; tried < 2; ++tried) {
            const std::size_t i = next_index(random, set.vibrations.size());
            const std::size_t j =
                (i + 1 + next_index(random, set.vibrations.size() - 1)) % set.vibrations.size();
            StepsQuestion question = question_of(std::get<Pattern>(set.vibrations[i].source),
                                                 std::get<Pattern>(set.vibrations[j].source), 4);
            question.model = set.model;
            const auto steps = even_steps(question, {});
            REQUIRE(steps);
            check_promise(question, *steps);
            const PatternSet written = set_of_steps(set, i, j, *steps);
            CHECK(written.vibrations.front() == set.vibrations[i]);
            CHECK(written.vibrations.back() == set.vibrations[j]);
            CHECK(written.vibrations.size() == 4);
        }
    }
}

TEST_CASE(
    "steps: along any number that files may hold, the way is straight and ends where it says") {
    RandomStream random{8};
    for (const PatternParameter parameter : kPatternParameters) {
        CAPTURE(traits(parameter).key);
        const Range range = traits(parameter).range;
        const auto any = [&] {
            return range.low + (0.5 + 0.5 * next_even(random)) * (range.high - range.low);
        };
        for (int tried = 0; tried < 12; ++tried) {
            Pattern a = short_pattern(0.5, 80.0, 4.0);
            a.carriers.push_back({120.0, 0.5});
            a.modulation.kind = ModulationKind::am;
            a.rhythm = {"x-", 0.02};
            a = with_value(a, parameter, tried == 0 ? range.low : any());
            const double to = tried == 0 ? range.high : tried == 1 ? range.low : any();
            const auto end = end_along(a, with_value(a, parameter, to), parameter);
            REQUIRE(end);
            CHECK(value_of(*end, parameter) == to);
            CHECK(morphed(a, *end, 0.0) == a);
            CHECK(morphed(a, *end, 1.0) == *end);
            const double sign = to >= *value_of(a, parameter) ? 1.0 : -1.0;
            double last = *value_of(a, parameter);
            for (int k = 1; k <= 10; ++k) {
                const double next = *value_of(morphed(a, *end, k / 10.0), parameter);
                CHECK(sign * (next - last) >= 0.0);
                last = next;
            }
        }
    }
}

TEST_CASE("steps: from a modulation of 250 Hz to one of 400 Hz they rise to 400 Hz") {
    const Pattern a = short_pattern(1.0, 450.0, 250.0);
    const auto end = end_along(a, short_pattern(1.0, 450.0, 400.0), PatternParameter::modulation);
    const auto steps = even_steps(question_of(a, *end, 3, StepMeasure::nc), {});
    REQUIRE(steps);
    CHECK(steps->patterns[1].modulation.frequency_hz > 250.0);
    CHECK(steps->patterns[1].modulation.frequency_hz < 400.0);
    CHECK(steps->patterns[2].modulation.frequency_hz == 400.0);
}

}  // namespace steps_test
