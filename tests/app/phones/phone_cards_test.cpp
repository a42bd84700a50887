// What phones are shown, and which of their answers are taken.
#include <doctest/doctest.h>

#include <nlohmann/json.hpp>

#include "app/phones/phones.h"

namespace phone_cards_test {

using namespace tact;
using nlohmann::json;

TEST_CASE("phone cards: a text stays one whatever is in it, and not UTF-8 breaks no card") {
    const std::vector<PhonePattern> patterns{{"<b>\"x\"</b>", {30, 10}, ""},
                                             {"a\xff", {5}, "weak"}};
    const auto card = json::parse(feel_card(patterns));
    CHECK(card.at("kind") == "feel");
    CHECK(card.at("patterns").at(0).at("name") == "<b>\"x\"</b>");
    CHECK(card.at("patterns").at(0).at("ms") == json{30, 10});
    CHECK(card.at("patterns").at(1).at("name") == "a\ufffd");
}

TEST_CASE("phone cards: before the reveal a card tells neither the votes nor the answer") {
    ChoiceCard question{"q", "Which?", {"one", "two"}};
    question.right = {1};
    question.votes = {3, 4};
    question.reveal = "Two, since";
    const std::string hidden = card_of(question);
    CHECK(hidden.find("votes") == hidden.npos);
    CHECK(hidden.find("since") == hidden.npos);
    question.revealed = true;
    const auto shown = json::parse(card_of(question)).at("revealed");
    CHECK(shown.at("right") == json{1});
    CHECK(shown.at("votes") == json{3, 4});
    CHECK(shown.at("text") == "Two, since");
}

TEST_CASE("phone answers: an option is one of those that there are") {
    CHECK(option_answered(R"({"option": 1})", 2) == 1U);
    for (const char* no : {R"({"option": 2})", R"({"option": -1})", R"({"option": 0.5})",
                           R"({"option": "1"})", R"({"option": null})", R"({})", "[]", "", "{",
                           R"({"option": 1e400})", R"({"option": true})"}) {
        CAPTURE(no);
        CHECK_FALSE(option_answered(no, 2));
    }
    CHECK_FALSE(option_answered(R"({"option": 0})", 0));
}

TEST_CASE("phone answers: who has not felt both sides has not rated them") {
    const std::string whole =
        R"({"k": 3, "similarity": 40.5, "plays": [1, 2], "first": "right", "response_ms": 2500})";
    const auto rating = rating_answered(whole);
    REQUIRE(rating);
    CHECK(rating->at == 3);
    CHECK(rating->similarity == 40.5);
    CHECK(rating->plays_left == 1);
    CHECK(rating->plays_right == 2);
    CHECK(rating->first == FeltFirst::right);
    CHECK(rating->response_s == doctest::Approx(2.5));
    const json good = json::parse(whole);
    const std::vector<std::pair<const char*, json>> faults{{"k", -1},
                                                           {"k", 0.5},
                                                           {"similarity", 100.5},
                                                           {"similarity", -1},
                                                           {"similarity", nullptr},
                                                           {"plays", {1, 0}},
                                                           {"plays", {0, 1}},
                                                           {"plays", {1}},
                                                           {"plays", {1, 1, 1}},
                                                           {"plays", 2},
                                                           {"response_ms", -1},
                                                           {"response_ms", "soon"}};
    for (const auto& [key, value] : faults) {
        json bad = good;
        bad[key] = value;
        CAPTURE(bad.dump());
        CHECK_FALSE(rating_answered(bad.dump()));
        bad.erase(key);
        CHECK_FALSE(rating_answered(bad.dump()));
    }
}

TEST_CASE("phone answers: of three plays each has to be felt") {
    const auto answer = trial_answered(R"({"option": 2, "plays": [1, 1, 3], "response_ms": 900})");
    REQUIRE(answer);
    CHECK(answer->place == 2);
    CHECK(answer->response_s == doctest::Approx(0.9));
    CHECK_FALSE(trial_answered(R"({"option": 2, "plays": [1, 0, 3], "response_ms": 900})"));
    CHECK_FALSE(trial_answered(R"({"option": 3, "plays": [1, 1, 3], "response_ms": 900})"));
    CHECK_FALSE(trial_answered(R"({"option": 2, "plays": [1, 1], "response_ms": 900})"));
}

}  // namespace phone_cards_test
