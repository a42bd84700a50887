#include "model/told_apart/told_apart_document.h"

#include <doctest/doctest.h>

#include "model/io/set/set_file.h"
#include "tests/support/set_texts.h"
#include "tests/support/temporary_folder.h"

namespace told_apart_json_test {

using namespace tact;

namespace {

std::string with_told(const std::string& fields) {
    return R"({"tactspace": 1, "patterns": [], "told_apart": [{)" + fields + "}]}";
}

constexpr const char* kPatterns = R"("patterns": ["a", "b"], "versions": ["1", "2"])";

// A measurement with this trial.
std::string with_trial(const std::string& fields) {
    return with_told(std::string(kPatterns) + R"(, "trials": [{)" + fields + "}]");
}

constexpr const char* kTrial =
    R"("a": "a", "b": "b", "pm": 9, "odd_one": "b", "odd_place": 3, "answer": 2, "response_s": 5.2)";

PatternSet parsed(const std::string& text) {
    auto set = parse_set(text, "s.json", {});
    REQUIRE_MESSAGE(set, (set ? "" : set.error().message));
    return *std::move(set);
}

}  // namespace

TEST_CASE("told apart in a file: it is written as people read it, and comes back") {
    PatternSet set;
    set.name = "n";
    set.told_apart.push_back({"phone Kim",
                              "Kim",
                              "2026-11-28T21:12:53Z",
                              42,
                              false,
                              {{{"a", "b", 9.0, 2, true}, 1, 5.5}},
                              {"a", "b"},
                              {"0123456789abcdef", "fedcba9876543210"}});
    CHECK(print_set(set) == R"({
  "tactspace": 1,
  "name": "n",
  "duration_s": 1.0,
  "patterns": [],
  "told_apart": [
    {
      "measured_on": "one person, on one device",
      "device": "phone Kim",
      "person": "Kim",
      "date": "2026-11-28T21:12:53Z",
      "seed": "000000000000002a",
      "patterns": [
        "a",
        "b"
      ],
      "versions": [
        "0123456789abcdef",
        "fedcba9876543210"
      ],
      "trials": [
        {
          "a": "a",
          "b": "b",
          "pm": 9.0,
          "odd_one": "b",
          "odd_place": 3,
          "answer": 2,
          "response_s": 5.5
        }
      ]
    }
  ]
}
)");
    CHECK(parsed(print_set(set)) == set);
}

TEST_CASE("told apart in a file: a set without it has no such key, and equals no set with it") {
    CHECK_FALSE(contains(print_set({}), "told_apart"));
    PatternSet set;
    set.told_apart.resize(1);
    CHECK(set != PatternSet{});
    CHECK(parsed(print_set(set)) == set);
    CHECK(parsed(R"({"tactspace": 1, "told_apart": []})") == PatternSet{});
}

TEST_CASE("told apart in a file: missing keys take defaults, but no trial is made up") {
    const ToldApart told = parsed(with_told("")).told_apart.at(0);
    CHECK(told == ToldApart{});
    const OddAnswer answer = parsed(with_trial(kTrial)).told_apart.at(0).answers.at(0);
    CHECK(answer == OddAnswer{{"a", "b", 9.0, 2, true}, 1, 5.2});
    CHECK(set_fault(with_trial(R"("a": "a", "b": "b", "pm": 9, "odd_one": "b", "odd_place": 3)")) ==
          "s.json: /told_apart/0/trials/0: expected \"answer\", got none");
    for (const char* key : {"a", "b", "pm", "odd_one", "odd_place", "answer"}) {
        std::string without = kTrial;
        const std::string quoted = "\"" + std::string(key) + "\"";
        without.replace(without.find(quoted + ":"), quoted.size(), "\"xx\"");
        CAPTURE(without);
        CHECK(set_fault(with_trial(without)).starts_with("s.json: "));
    }
}

TEST_CASE("told apart in a file: whatever is no trial is refused with its place") {
    const auto changed = [](const std::string& before, const std::string& after) {
        std::string trial = kTrial;
        trial.replace(trial.find(before), before.size(), after);
        return set_fault(with_trial(trial));
    };
    const std::string at = "s.json: /told_apart/0/trials/0/";
    CHECK(changed(R"("pm": 9)", R"("pm": -1)").starts_with(at + "pm: expected a number from 0"));
    CHECK(changed(R"("odd_place": 3)", R"("odd_place": 4)") ==
          at + "odd_place: expected a whole number from 1 to 3, got 4");
    CHECK(changed(R"("answer": 2)", R"("answer": 0)").starts_with(at + "answer: expected"));
    CHECK(changed(R"("answer": 2)", R"("answer": 1.5)").starts_with(at + "answer: expected"));
    CHECK(changed(R"("odd_one": "b")", R"("odd_one": "c")").starts_with(at + "odd_one: expected"));
    CHECK(changed(R"("a": "a")", R"("a": "c")") ==
          at + "a: expected a name among the patterns of the trials, got \"c\"");
    CHECK(changed(R"("b": "b")", R"("b": "a")") ==
          at + "b: expected another pattern than a, got \"a\"");
    CHECK(changed("5.2", "-1").starts_with(at + "response_s: expected a number"));
    CHECK(changed("5.2", "\"5\"").starts_with(at + "response_s: expected a number"));
}

TEST_CASE("told apart in a file: whatever is no measurement is refused with its place") {
    const std::string at = "s.json: /told_apart/0/";
    CHECK(set_fault(R"({"tactspace": 1, "told_apart": {}})")
              .starts_with("s.json: /told_apart: expected an array"));
    CHECK(set_fault(R"({"tactspace": 1, "told_apart": [3]})")
              .starts_with("s.json: /told_apart/0: expected"));
    CHECK(set_fault(with_told(R"("device": 3)")).starts_with(at + "device: expected a text"));
    CHECK(set_fault(with_told(R"("seed": "2a")")) ==
          at + "seed: expected 16 hexadecimal digits, got \"2a\"");
    CHECK(set_fault(with_told(R"("seed": 42)")).starts_with(at + "seed: expected"));
    CHECK(set_fault(with_told(R"("seed": "-000000000000001")")).starts_with(at + "seed: expected"));
    CHECK(set_fault(with_told(R"("measured_on": "many people")"))
              .starts_with(at + "measured_on: expected"));
    CHECK(set_fault(with_told(R"("patterns": ["a", "b"], "versions": ["1"])")) ==
          at + "versions: expected a version for each of 2 patterns, got 1");
    CHECK(set_fault(with_told(R"("patterns": ["a", "a"], "versions": ["1", "2"])")) ==
          at + "patterns/1: expected names that differ, got \"a\" twice");
    std::string many = std::string(kPatterns) + R"(, "trials": [)";
    for (int k = 0; k < 41; ++k) many += std::string(k == 0 ? "{" : ",{") + kTrial + "}";
    CHECK(
        set_fault(with_told(many + "]")).starts_with(at + "trials: expected an array of 0 to 40"));
}

TEST_CASE("told apart in a file: keys of other versions are kept, of a trial, too") {
    const PatternSet set =
        parsed(with_told(std::string(R"("mood": "good", )") + kPatterns + R"(, "trials": [{)" +
                         kTrial + "}, {" + kTrial + R"(, "confidence": 4}])"));
    const std::string text = print_set(set);
    CHECK(contains(text, "\"mood\": \"good\""));
    CHECK(contains(text, "\"confidence\": 4"));
    CHECK(parsed(text) == set);
    CHECK(set_fault(with_told(R"("perzon": "Kim")")) ==
          "s.json: /told_apart/0: does not know \"perzon\"; the nearest key is \"person\"");
    CHECK(contains(set_fault(with_trial(std::string(kTrial) + R"(, "respons_s": 3)")),
                   "the nearest key is \"response_s\""));
}

}  // namespace told_apart_json_test
