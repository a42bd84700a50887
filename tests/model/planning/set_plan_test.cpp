// The plan of a set: the same as its parts, and refused where nothing can be planned.
#include "model/planning/set_plan.h"

#include <doctest/doctest.h>

#include "model/evaluation/metric_comparison.h"
#include "model/set/set_ratings.h"

namespace set_plan_test {

using namespace tact;

namespace {

PlanQuestion question_of_five() {
    PatternSet set;
    for (int k = 0; k < 5; ++k) {
        Pattern pattern;
        pattern.duration_s = 0.1;
        pattern.amplitude_g = 0.4 + 0.3 * k;
        pattern.carriers[0].frequency_hz = 60.0 + 45.0 * ((k * 3) % 5);
        Vibration vibration;
        vibration.name = "p" + std::to_string(k);
        vibration.source = pattern;
        set.vibrations.push_back(vibration);
    }
    return {.set = set, .people = {4}, .studies = 5};
}

}  // namespace

TEST_CASE("set plan: the studies are those of its matrices, and its pattern count") {
    const PlanQuestion question = question_of_five();
    const auto plan = set_plan(question);
    REQUIRE(plan);
    const auto matrices =
        *compared_matrices(question.set, std::vector{Metric::pm, Metric::msm}, nullptr, {});
    CHECK(plan->plan.metric.condensed == matrices[0].condensed);
    CHECK(plan->plan.rival.condensed == matrices[1].condensed);
    PlanParams how;
    how.studies = 5;
    const auto studies = planned_studies(plan->plan, question.people, how);
    REQUIRE(studies);
    CHECK(plan->studies[0].rho == (*studies)[0].rho);
    CHECK(plan->plan.assumed.source == guessed_assumptions().source);
    CHECK(minutes_of(*plan) > 0.0);
}

TEST_CASE("set plan: deciding patterns are planned by matrices of their own") {
    PlanQuestion question = question_of_five();
    question.decide = 4;
    const auto plan = set_plan(question);
    REQUIRE(plan);
    REQUIRE(plan->decided);
    CHECK(plan->set.vibrations.size() == 4);
    CHECK(plan->plan.metric.size == 4);
    const auto own = *compared_matrices(plan->set, std::vector{Metric::pm}, nullptr, {});
    CHECK(plan->plan.metric.condensed == own[0].condensed);
    const Preregistration frozen = preregistration_of(*plan, "five", "program 1", "today");
    CHECK(frozen.patterns == names_of(plan->set));
    CHECK(frozen.people == 4);
    CHECK(frozen.set_fingerprint == study_fingerprint(plan->set, frozen.patterns));
}

TEST_CASE("set plan: what is stated is named so; a part of it, too") {
    PlanQuestion question = question_of_five();
    question.rho = 0.5;
    CHECK(set_plan(question)->plan.assumed.source == "stated, and the rest guessed");
    question.reliability = 0.6;
    const auto plan = set_plan(question);
    CHECK(plan->plan.assumed.source == "stated");
    CHECK(plan->plan.assumed.rho == 0.5);
    CHECK(plan->plan.assumed.reliability == 0.6);
}

TEST_CASE("set plan: too few patterns, PM against itself, more than there is are refused") {
    const auto fault = [](auto change) {
        PlanQuestion question = question_of_five();
        change(question);
        const auto plan = set_plan(question);
        return plan ? std::string() : plan.error().message;
    };
    CHECK(fault([](PlanQuestion& q) { q.set.vibrations.resize(2); }).starts_with("expected at "));
    CHECK(fault([](PlanQuestion& q) { q.rival = Metric::pm; }).find("than pm") !=
          std::string::npos);
    CHECK(fault([](PlanQuestion& q) { q.decide = 6; }).find("the 5 patterns") != std::string::npos);
    CHECK(fault([](PlanQuestion& q) { q.pairs = 11; }).find("the 10 pairs") != std::string::npos);
    CHECK(fault([](PlanQuestion& q) {
              q.decide = 4;
              q.pairs = 7;
          }).find("the 6 pairs") != std::string::npos);
    std::stop_source stop;
    stop.request_stop();
    const auto stopped = set_plan(question_of_five(), {stop.get_token(), {}});
    CHECK_FALSE(stopped);
}

TEST_CASE("set plan: a range of people stands for eight numbers at most, with both ends") {
    CHECK(people_between(5, 40) == std::vector<std::size_t>{5, 10, 15, 20, 25, 30, 35, 40});
    CHECK(people_between(3, 5) == std::vector<std::size_t>{3, 4, 5});
    CHECK(people_between(7, 7) == std::vector<std::size_t>{7});
    CHECK(people_between(1, 1000).size() == 8);
    CHECK(people_between(1, 1000).back() == 1000);
}

}  // namespace set_plan_test
