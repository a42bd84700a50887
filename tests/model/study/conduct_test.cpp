#include "model/study/conduct.h"

#include <doctest/doctest.h>

#include <cmath>

#include "model/study/study_results.h"

namespace conduct_test {

using namespace tact;

namespace {

// Three patterns rated in two passes, the second by other values.
StudyRecord rater(const std::string& code, const std::vector<double>& first,
                  const std::vector<double>& second, double response_s, int plays = 1) {
    StudyRecord record;
    record.header.patterns = {"a", "b", "c"};
    record.header.participant.code = code;
    record.header.design.repetitions = 2;
    record.header.design.attention_pairs = 0;
    for (const auto* pass : {&first, &second}) {
        for (std::size_t p = 0; p < pass->size(); ++p) {
            const auto [i, j] = pair_at(3, p);
            record.answers.push_back({{i, j}, (*pass)[p], plays, 1, response_s, ""});
        }
    }
    return record;
}

std::vector<StudyRecord> people() {
    return {rater("careful", {10, 50, 90}, {20, 50, 80}, 8.0),
            rater("fast", {10, 50, 90}, {20, 50, 80}, 0.5),
            rater("wavering", {10, 50, 90}, {90, 50, 10}, 8.0),
            rater("lost", {10, 50, 90}, {20, 50, 80}, 8.0, 9)};
}

std::string why(const CollectRule& rule, const std::string& code) {
    const auto results = study_results(people(), rule);
    REQUIRE(results);
    for (const ParticipantSummary& person : results->people) {
        if (person.code == code) return person.excluded;
    }
    return "nobody of that name";
}

CollectRule with(const ConductRule& conduct) {
    CollectRule rule;
    rule.who.conduct = conduct;
    return rule;
}

}  // namespace

TEST_CASE("conduct: without a rule nobody is left out for how they answered") {
    const auto results = study_results(people(), {});
    REQUIRE(results);
    for (const ParticipantSummary& person : results->people) CHECK(person.excluded.empty());
    CHECK(results->remarks.empty());
    CHECK(results->people[2].code == "lost");
    CHECK(results->people[2].conduct.replays == 8.0);
    CHECK(results->people[3].conduct.repeat_rho == -1.0);
    CHECK(results->people[0].conduct.repeat_rho == 1.0);
    CHECK(results->people[1].conduct.median_response_s == 0.5);
}

TEST_CASE("conduct: each rule leaves out those whom it is meant for, and says why") {
    const CollectRule fast = with({.fast_below_s = 2.0});
    CHECK(why(fast, "fast") == "6 of 6 answers in under 2 s, expected at most 10 %");
    CHECK(why(fast, "careful").empty());
    CHECK(why(fast, "wavering").empty());
    const CollectRule repeats = with({.repeat_rho = 0.5});
    CHECK(why(repeats, "wavering") == "own repetitions agree with rho -1, expected 0.5 at least");
    CHECK(why(repeats, "fast").empty());
    const CollectRule replays = with({.replays = 3.0});
    CHECK(why(replays, "lost") == "8 replays a trial on average, expected at most 3");
    CHECK(why(replays, "careful").empty());
}

TEST_CASE("conduct: what is just allowed is allowed") {
    CHECK(why(with({.fast_below_s = 0.5}), "fast").empty());
    CHECK(why(with({.fast_below_s = 2.0, .fast_share = 1.0}), "fast").empty());
    CHECK(why(with({.repeat_rho = -1.0}), "wavering").empty());
    CHECK(why(with({.replays = 8.0}), "lost").empty());
}

TEST_CASE("conduct: each rule is named in the results with who fell by it, also if nobody did") {
    const auto results = study_results(people(), with({.fast_below_s = 2.0, .replays = 100.0}));
    REQUIRE(results);
    REQUIRE(results->remarks.size() == 3);
    CHECK(results->remarks[0] ==
          "fast is not counted: 6 of 6 answers in under 2 s, expected at most 10 %");
    CHECK(results->remarks[1] == "rule: at most 10 % of the answers in under 2 s; fast fell by it");
    CHECK(results->remarks[2] ==
          "rule: at most 100 replays a trial on average; nobody falls by it");
}

TEST_CASE("conduct: who is included by name counts though they fall by a rule") {
    CollectRule rule = with({.fast_below_s = 2.0});
    rule.who.include = {"fast"};
    CHECK(why(rule, "fast").empty());
}

TEST_CASE("conduct: of a single pass nothing is known of repetitions, and nobody falls by it") {
    StudyRecord once = rater("once", {10, 50, 90}, {}, 8.0);
    once.header.design.repetitions = 1;
    CHECK(std::isnan(conduct_of(once).repeat_rho));
    CHECK(fault_of(once, {.repeat_rho = 1.0}, ConductTest::repetition).empty());
}

TEST_CASE("conduct: what was not felt whole says nothing of how someone answers") {
    StudyRecord record = rater("P1", {10, 50, 90}, {20, 50, 80}, 8.0);
    record.answers[0].response_s = 0.1;
    record.answers[0].plays_left = 0;
    record.answers[0].left.broken = 1;
    CHECK(conduct_of(record).answers == 5);
    CHECK(fault_of(record, {.fast_below_s = 1.0, .fast_share = 0.0}, ConductTest::speed).empty());
}

TEST_CASE("conduct: ratings without a record of times refuse rules on them") {
    const RatingStudy study{{"a", "b"}, true, {{"P1", {3}}}, {}, {}};
    CountRule rule;
    rule.conduct.fast_below_s = 2.0;
    const auto counted = who_counts(study, rule);
    REQUIRE_FALSE(counted);
    CHECK(counted.error().message.starts_with("expected the folder of a study"));
}

TEST_CASE("conduct: at most so many percent are that many of a hundred, for every percent") {
    for (int percent = 1; percent < 100; ++percent) {
        CAPTURE(percent);
        StudyRecord record = rater("quick", {10, 50, 90}, {20, 50, 80}, 8.0);
        const PairAnswer one = record.answers.front();
        record.answers.assign(100, one);
        for (int k = 0; k < percent; ++k)
            record.answers[static_cast<std::size_t>(k)].response_s = 0.5;
        ConductRule rule{.fast_below_s = 2.0};
        rule.fast_share =
            std::stod("0." + std::string(percent < 10 ? "0" : "") + std::to_string(percent));
        CHECK(fault_of(record, rule, ConductTest::speed).empty());
        record.answers[static_cast<std::size_t>(percent)].response_s = 0.5;
        CHECK_FALSE(fault_of(record, rule, ConductTest::speed).empty());
    }
}

}  // namespace conduct_test
