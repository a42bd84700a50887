#include "model/planning/preregistration.h"

#include <algorithm>
#include <cmath>

#include "model/io/studies_out/preregistration_file.h"
#include "tests/support/golden.h"

namespace preregistration_test {

using namespace tact;

namespace {

Preregistration some_plan() {
    Preregistration plan;
    plan.date = "2026-11-28T12:00:00Z";
    plan.program = "tactspace 0.1.0";
    plan.set_name = "twelve";
    plan.set_fingerprint = "0123456789abcdef";
    plan.model_fingerprint = "fedcba9876543210";
    plan.patterns = {"a", "b", "c"};
    plan.people = 20;
    plan.pairs = 2;
    plan.rival = "msm";
    plan.assumed = {0.67, 0.4, "stated"};
    plan.expected.people = 20;
    plan.expected.rho = 0.6;
    plan.expected.rho_rival = 0.4;
    plan.expected.half_width = {0.2, std::nan(""), 0.25};
    plan.expected.power = {0.7, std::nan(""), 0.5};
    return plan;
}

DoneStudy as_planned(const Preregistration& plan) {
    return {
        plan.set_fingerprint, plan.model_fingerprint, plan.patterns, plan.people,  plan.repetitions,
        plan.attention_pairs, plan.attention,         plan.order,    plan.scaling, {}};
}

std::size_t departures(const Preregistration& plan, const DoneStudy& study) {
    const auto lines = planned_and_done(plan, study);
    return static_cast<std::size_t>(std::ranges::count(lines, false, &PlannedAndDone::is_kept));
}

}  // namespace

TEST_CASE("preregistration: a file of it reads back as it was, unknown numbers among it") {
    const Preregistration plan = some_plan();
    const std::string text = print_preregistration(plan);
    const auto read = parse_preregistration(text, "p.json");
    REQUIRE(read);
    CHECK(print_preregistration(*read) == text);
    CHECK(read->patterns == plan.patterns);
    CHECK(std::isnan(read->expected.power[1]));
    CHECK(read->expected.power[2] == 0.5);
    CHECK(read->assumed.source == "stated");
}

TEST_CASE("preregistration: a file of something else is refused with its place") {
    for (const auto& [text, place] :
         {std::pair{R"({})", "/tactspace_preregistration"},
          {R"({"tactspace_preregistration": 2})", "/tactspace_preregistration"},
          {R"({"tactspace_preregistration": 1, "patterns": ["a"]})", "/patterns"},
          {R"({"tactspace_preregistration": 1, "patterns": [1, 2, 3]})", "/patterns"},
          {R"({"tactspace_preregistration": 1, "people": -3})", "/people"},
          {R"({"tactspace_preregistration": 1, "order": "best"})", "/order"},
          {"[]", "expected"}}) {
        const auto read = parse_preregistration(text, "p.json");
        REQUIRE_FALSE(read);
        CHECK_MESSAGE(read.error().message.find(place) != std::string::npos, read.error().message);
        CHECK(read.error().message.starts_with("p.json"));
    }
}

TEST_CASE("preregistration: each thing that is done otherwise is one departure, and named") {
    const Preregistration plan = some_plan();
    CHECK(departures(plan, as_planned(plan)) == 0);
    const std::vector<void (*)(DoneStudy&)> others{
        [](DoneStudy& s) { s.set_fingerprint = "other"; },
        [](DoneStudy& s) { s.model_fingerprint = "other"; },
        [](DoneStudy& s) { s.patterns.pop_back(); },
        [](DoneStudy& s) { s.people = 19; },
        [](DoneStudy& s) { s.repetitions = 2; },
        [](DoneStudy& s) { s.attention_pairs = 1; },
        [](DoneStudy& s) { s.attention.above = 60.0; },
        [](DoneStudy& s) { s.attention.failures_allowed = 1; },
        [](DoneStudy& s) { s.order = StudyOrder::adaptive; },
        [](DoneStudy& s) { s.scaling = RatingScaling::standard; },
        [](DoneStudy& s) { s.left_out_by_hand = {"P3"}; }};
    for (const auto& change : others) {
        DoneStudy study = as_planned(plan);
        change(study);
        CHECK(departures(plan, study) == 1);
    }
}

}  // namespace preregistration_test
