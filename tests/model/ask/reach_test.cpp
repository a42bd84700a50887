#include "model/ask/reach.h"

#include <doctest/doctest.h>

#include <cstdio>
#include <string>

#include "model/map/mds.h"
#include "tests/model/ask/short_sets.h"

namespace reach_test {

using namespace tact;

namespace {

struct Bench {
    PatternSet set = short_set(6);
    Pattern own = std::get<Pattern>(set.vibrations[1].source);
    MovedPoint map = *MovedPoint::of(
        {model_waveforms(set),
         set.model,
         nonmetric_mds(predict(model_waveforms(set), set.model)->pm, standard_mds_params(6, 3))
             .points,
         {}},
        1, 0, {});
};

}  // namespace

TEST_CASE("reach: a place that a change leads to is reached within 5 %, repeatably") {
    const Bench bench;
    Pattern meant = bench.own;
    meant.amplitude_g = 1.4;
    meant.carriers[0].frequency_hz = 160.0;
    const ReachQuestion question{bench.own, bench.map(render(meant), {})->at};
    ReachOptions one;
    one.threads = 1;
    ReachOptions four;
    four.threads = 4;
    const auto found = reach(question, bench.map, one);
    REQUIRE(found);
    INFO("off " << found->off_pm << " of " << found->largest_pm);
    CHECK(is_reached(*found));
    CHECK((bench.map(render(found->pattern), {})->at - found->at).norm() == 0.0);
    // 160 Hz, not 163.278: two numbers that can be typed, each within a felt step of another.
    for (const PatternParameter number : {PatternParameter::amplitude, PatternParameter::carrier}) {
        const double value = *value_of(found->pattern, number);
        char text[32];
        std::snprintf(text, sizeof text, "%.3g", value);
        CHECK(std::stod(text) == value);
    }
    const auto again = reach(question, bench.map, four);
    CHECK(again->pattern == found->pattern);
    CHECK(again->off == found->off);
}

TEST_CASE("reach: a place that nothing leads to says so, and leaves the best") {
    const Bench bench;
    ReachQuestion question{bench.own, Eigen::RowVectorXd::Constant(3, 50.0)};
    const auto far = reach(question, bench.map, {});
    REQUIRE(far);
    CHECK_FALSE(is_reached(*far));
    const double before = (bench.map(render(bench.own), {})->at - question.target).norm();
    CHECK(far->off <= before);
    question.free = {PatternParameter::depth};  // it has none
    const auto stuck = reach(question, bench.map, {});
    CHECK(stuck->pattern == bench.own);
    std::stop_source stop;
    stop.request_stop();
    ReachOptions stopped;
    stopped.stop = stop.get_token();
    CHECK_FALSE(reach(question, bench.map, stopped));
}

}  // namespace reach_test
