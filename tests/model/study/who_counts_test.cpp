#include "model/study/who_counts.h"

#include <doctest/doctest.h>

#include "tests/support/temporary_folder.h"

namespace who_counts_test {

using namespace tact;

namespace {

RatingStudy crowd() {
    return {{"a", "b", "c"},
            true,
            {{"good", {1, 2, 3}}, {"blind", {3, 2, 1}}, {"good", {1, 2, 4}}, {"dry", {9, 9, 9}}},
            {{"blind", false, false, "identical patterns rated 10"},
             {"dry", false, true, kNothingFelt},
             {"absent", false, false, "no answer"}}};
}

std::vector<std::string> people_of(const Counted& counted) {
    std::vector<std::string> people;
    for (const Judgement& one : counted.study.judgements) people.push_back(one.participant);
    return people;
}

std::string fault_of(const CountRule& rule) {
    const auto counted = who_counts(crowd(), rule);
    REQUIRE_FALSE(counted);
    return counted.error().message;
}

}  // namespace

TEST_CASE("who counts: the excluded and rehearsals are left out, each with the reason") {
    const auto counted = who_counts(crowd());
    REQUIRE(counted);
    CHECK(people_of(*counted) == std::vector<std::string>{"good", "good"});
    CHECK(counted->left_out ==
          std::vector<LeftOutParticipant>{{"blind", "identical patterns rated 10"},
                                          {"dry", kNothingFelt},
                                          {"absent", "no answer"}});
    CHECK(counted->study.standings.empty());
    CHECK(remarks_on(counted->left_out)[0] == "blind is not counted: identical patterns rated 10");
}

TEST_CASE("who counts: a rehearsal is left out though nothing else is said of it") {
    const RatingStudy study{
        {"a", "b", "c"}, true, {{"good", {1, 2, 3}}, {"dry", {3, 2, 1}}}, {{"dry", false, true}}};
    const auto counted = who_counts(study);
    REQUIRE(counted);
    CHECK(people_of(*counted) == std::vector<std::string>{"good"});
    CHECK(counted->left_out == std::vector<LeftOutParticipant>{{"dry", kNothingFelt}});
}

TEST_CASE("who counts: a name brings the excluded back and sends others away, but no rehearsal") {
    const auto counted = who_counts(crowd(), {{"blind"}, {"good"}});
    REQUIRE(counted);
    CHECK(people_of(*counted) == std::vector<std::string>{"blind"});
    CHECK(counted->left_out[0] == LeftOutParticipant{"good", "excluded by name"});
    CHECK(contains(fault_of({{"dry"}, {}}), "expected a participant who felt something"));
    CHECK(fault_of({{}, {"nobody"}}) == "expected the name of a participant, got \"nobody\"");
    CHECK(contains(fault_of({{"blind"}, {"blind"}}), "got both"));
}

TEST_CASE(
    "who counts: whoever nothing is said of counts, and passing the gate twice changes nothing") {
    const RatingStudy plain{{"a", "b", "c"}, true, {{"x", {1, 2, 3}}, {"y", {1, 2, 3}}}};
    CHECK(who_counts(plain)->study == plain);
    const RatingStudy once = who_counts(crowd())->study;
    CHECK(who_counts(once)->study == once);
    CHECK(who_counts(once)->left_out.empty());
}

TEST_CASE("who counts: nobody is averaged with a simulation, unless it is asked for by name") {
    RatingStudy study{
        {"a", "b", "c"},
        true,
        {{"Ann", {1, 2, 3}}, {"S01", {3, 2, 1}}, {"Bob", {1, 2, 4}}, {"S02", {9, 9, 9}}},
        {{"S01", true}, {"S02", true, false, "no answer"}}};
    const auto counted = who_counts(study);
    REQUIRE(counted);
    CHECK(people_of(*counted) == std::vector<std::string>{"Ann", "Bob"});
    CHECK(counted->left_out ==
          std::vector<LeftOutParticipant>{{"S01", kSimulated}, {"S02", kSimulated}});
    CHECK(words_on_simulated(counted->study) == "");
    const auto asked = who_counts(study, {{"S01"}, {}});
    REQUIRE(asked);
    CHECK(people_of(*asked) == std::vector<std::string>{"Ann", "S01", "Bob"});
    CHECK(words_on_simulated(asked->study) == "1 of 3 were simulated");
    // Simulated participants alone are a study that says so, with a rehearsal beside them or not.
    for (const bool rehearsed : {false, true}) {
        RatingStudy alone = study;
        std::erase_if(alone.judgements,
                      [](const Judgement& one) { return !one.participant.starts_with('S'); });
        alone.standings[1].excluded.clear();
        if (rehearsed) {
            alone.judgements.push_back({"dry", {1, 1, 1}});
            alone.standings.push_back({"dry", false, true, {}});
        }
        const auto simulated = who_counts(alone);
        REQUIRE(simulated);
        CHECK(people_of(*simulated) == std::vector<std::string>{"S01", "S02"});
        CHECK(words_on_simulated(simulated->study) == "nobody was asked");
    }
}

TEST_CASE("ratings: synthetic ones are known as long as one of them is counted") {
    RatingStudy study = crowd();
    CHECK_FALSE(is_partly_synthetic(study));
    study.standings.push_back({"good", true});
    CHECK(is_partly_synthetic(study));
    CHECK_FALSE(is_partly_synthetic(who_counts(study, {{"blind"}, {"good"}})->study));
}

}  // namespace who_counts_test
