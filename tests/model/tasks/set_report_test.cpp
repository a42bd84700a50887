#include "model/tasks/set_report.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "model/subset/set_subset.h"

namespace set_report_test {

using namespace tact;

namespace {

// The first two feel the same, the third is not felt, the last is locked.
PatternSet some_set() {
    PatternSet set;
    for (const double f_hz : {150.0, 155.0, 210.0, 60.0, 250.0, 90.0}) {
        Pattern pattern;
        pattern.duration_s = 0.1;
        pattern.carriers[0].frequency_hz = f_hz;
        pattern.amplitude_g = f_hz == 210.0 ? 0.0 : 1.0;
        Vibration vibration;
        vibration.name = "f" + std::to_string(static_cast<int>(f_hz));
        vibration.source = pattern;
        vibration.locked = f_hz == 90.0;
        set.vibrations.push_back(vibration);
    }
    return set;
}

}  // namespace

TEST_CASE(
    "set report: picks are felt, what feels the same is grouped, and the weakest pair tells") {
    const PatternSet set = some_set();
    const auto report = set_report(set, set);
    REQUIRE(report);
    CHECK(report->fault.empty());
    const auto pairs = set_pairs(set);
    CHECK(report->pairs == *pairs);
    CHECK(report->left_out == std::vector<std::size_t>{2});
    // Half of six, among them the locked one.
    const auto problem = subset_problem(set, 3, SubsetObjective::max_min, pairs->unfelt);
    CHECK(report->subset == *most_distinct_subset(pairs->apart, problem));
    CHECK(report->closer_than == report->subset.best.weakest_dissimilarity);
    REQUIRE(report->alike.confused.groups.size() == 1);
    CHECK(report->alike.confused.groups[0].members == std::vector<std::size_t>{0, 1});
    CHECK(report->alike.groups.size() == 3);
    CHECK(std::isinf(report->alike.closer.nearest[2].dissimilarity));
    CHECK(report->space.points.rows() == 6);
    CHECK_FALSE(report->stability);
    const nlohmann::json json = json_of(*report, set);
    CHECK(json.at("not_felt") == std::vector<std::string>{"f210"});
    CHECK(json.at("left_out_unfelt") == std::vector<std::string>{"f210"});
    CHECK(json.at("nearest").at("f150").at("verdict") == "same");
    CHECK(json.at("nearest").at("f210").at("verdict") == nullptr);
    CHECK(json.at("distinct") == 5);
}

TEST_CASE("set report: it is of what is felt, and locks are those of the set that is meant") {
    const PatternSet meant = some_set();
    PatternSet felt = meant;
    for (Vibration& one : felt.vibrations) {
        std::get<Pattern>(one.source).carriers[0].frequency_hz += 60.0;
        one.locked = false;
    }
    SetReportRequest request;
    request.draws = 2;
    const auto report = set_report(meant, felt, request);
    REQUIRE(report);
    CHECK(report->pairs == *set_pairs(felt));
    CHECK(std::ranges::binary_search(report->subset.best.members, std::size_t{5}));
    REQUIRE(report->stability);
    CHECK(report->stability->draws == 2);
    const std::vector<std::size_t> unfelt{2};
    const auto problem = subset_problem(meant, 3, SubsetObjective::max_min, unfelt);
    const auto same =
        subset_stability(felt, problem, report->subset.best, report->space.points, {.draws = 2});
    REQUIRE(same);
    CHECK(report->stability->share_picked == same->share_picked);
}

TEST_CASE("set report: a number or a pair decides what is close, and unfelt ones may be picked") {
    const PatternSet set = some_set();
    SetReportRequest request;
    request.closer_than_pair = {3, 4};
    const auto by_pair = set_report(set, set, request);
    CHECK(by_pair->closer_than == by_pair->pairs.apart(3, 4));
    request.closer_than = 2.5;
    request.picks_unfelt = true;
    request.count = 6;
    const auto report = set_report(set, set, request);
    CHECK(report->closer_than == 2.5);
    CHECK(report->left_out.empty());
    CHECK(report->subset.best.members.size() == 6);
    CHECK(report->pairs.unfelt == std::vector<std::size_t>{2});
    CHECK(report->alike.groups.size() == 5);
}

TEST_CASE("set report: more than there are cannot be picked, and a stop leaves none") {
    const PatternSet set = some_set();
    SetReportRequest request;
    request.count = 6;
    const auto report = set_report(set, set, request);
    REQUIRE(report);
    CHECK_FALSE(report->fault.empty());
    CHECK(report->left_out.size() == 1);
    std::stop_source stop;
    stop.request_stop();
    request.stop = stop.get_token();
    CHECK_FALSE(set_report(set, set, request));
}

}  // namespace set_report_test
