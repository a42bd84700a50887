// Trials of three on one phone: what plays is what is asked, and what is kept is what was said.
#include <doctest/doctest.h>

#include <nlohmann/json.hpp>

#include "app/phones/phones.h"
#include "tests/support/program.h"

namespace device_trials_test {

using namespace tact;
using nlohmann::json;

namespace {

std::vector<PhonePattern> four() {
    return {{"p1", {20, 10}, ""}, {"p2", {40, 10}, ""}, {"p3", {60, 10}, ""}, {"p4", {0, 90}, ""}};
}

TrialDesign design() {
    return {10, 3, {{"p1", "p2", 3.0}, {"p1", "p3", 9.0}, {"p2", "p3", 20.0}, {"p1", "p4", 1.0}}};
}

// The place whose times occur once.
std::size_t odd_of(const json& ms) { return ms[0] == ms[1] ? 2U : ms[0] == ms[2] ? 1U : 0U; }

std::string answer(std::size_t place) {
    return json{{"option", place}, {"plays", {1, 1, 1}}, {"response_ms", 800}}.dump();
}

}  // namespace

TEST_CASE("device trials: two of three are one pattern, and who finds the other is right") {
    auto trials = device_trials(design(), four(), "Kim");
    REQUIRE(trials);
    for (int k = 0; k < 10; ++k) {
        const json card = json::parse(card_of(*trials));
        CHECK(card.at("at") == k + 1);
        CHECK(card.at("of") == 10);
        const std::size_t odd = odd_of(card.at("ms"));
        CHECK(card.at("ms").at((odd + 1) % 3) == card.at("ms").at((odd + 2) % 3));
        CHECK(card.at("ms").at(odd) != card.at("ms").at((odd + 1) % 3));
        CHECK_FALSE(is_done(*trials));
        CHECK(take_trial(*trials, card.at("id"), answer(odd)));
    }
    CHECK(is_done(*trials));
    CHECK(json::parse(card_of(*trials)).at("kind") == "thanks");
    const ToldApart told = told_apart_of(*trials, short_patterns(4));
    CHECK(told.answers.size() == 10);
    for (const OddAnswer& one : told.answers) CHECK(one.is_right());
    CHECK(told.person == "Kim");
    CHECK(told.versions.size() == told.patterns.size());
}

TEST_CASE("device trials: what a phone cannot play is not asked about") {
    const auto trials = device_trials(design(), four(), "Kim");
    REQUIRE(trials);
    for (const TrialPair& pair : trials->design.pairs) CHECK(pair.b != "p4");
    CHECK_FALSE(device_trials({10, 1, {{"p1", "p4", 1.0}}}, four(), "Kim"));
    CHECK_FALSE(device_trials({10, 1, {{"p1", "gone", 1.0}}}, four(), "Kim"));
}

TEST_CASE("device trials: an answer counts once, and for the trial that is on") {
    auto trials = device_trials(design(), four(), "Kim");
    const std::string first = json::parse(card_of(*trials)).at("id");
    CHECK_FALSE(take_trial(*trials, "trial 3.2", answer(0)));
    CHECK_FALSE(take_trial(*trials, first, "{}"));
    CHECK(take_trial(*trials, first, answer(0)));
    CHECK_FALSE(take_trial(*trials, first, answer(1)));
    CHECK(trials->answers.size() == 1);
}

}  // namespace device_trials_test
