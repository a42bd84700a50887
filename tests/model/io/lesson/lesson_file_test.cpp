// Lesson files: a written file reads back the same, and an error names its place.
#include "model/io/lesson/lesson_file.h"

#include <doctest/doctest.h>

#include "assets/assets.h"
#include "tests/support/temporary_folder.h"

namespace lesson_file_test {

using namespace tact;

namespace {

std::string fault_of(const std::string& text) {
    const auto lesson = parse_lesson(text, "l.json", {});
    REQUIRE_FALSE(lesson);
    return lesson.error().message;
}

// A lesson on the paper's twelve patterns with one step, whose fields are given.
std::string one_step(const std::string& fields) {
    return R"({"tactlesson": 1, "set": "pm_2023_twelve", "steps": [{)" + fields + "}]}";
}

bool holds(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

}  // namespace

TEST_CASE("lesson file: every bundled lesson is stored exactly as the program writes it") {
    int lessons = 0;
    for (const Asset& file : assets()) {
        if (!file.path.starts_with("lessons/")) continue;
        ++lessons;
        CAPTURE(file.path);
        const auto lesson = parse_lesson(file.text, std::string(file.path), {});
        REQUIRE_MESSAGE(lesson, (lesson ? "" : lesson.error().message));
        CHECK(print_lesson(*lesson, {}) == file.text);
        CHECK(*parse_lesson(print_lesson(*lesson, {}), "again", {}) == *lesson);
    }
    CHECK(lessons == 9);
}

TEST_CASE("lesson file: what a step may say comes back whole") {
    const TemporaryFolder folder;
    auto lesson =
        parse_lesson(one_step(R"("title": "T", "text": "{nc | L-0-half | H-0-half}", "note": "n",
            "source": "s", "pattern": "L-0-half", "partner": "H-0-half", "view": "map",
            "point_at": "space", "at_s": 0.1, "speed": 0.5, "from_s": 0.2, "to_s": 0.4,
            "camera": {"yaw_rad": 1.0, "pitch_rad": 0.5, "zoom": 2.0},
            "question": {"kind": "farthest", "ask": "a", "reveal": "r",
                         "pairs": [["L-0-half", "H-0-half"], ["L-0-half", "L-0-full"]]})"),
                     "l.json", {});
    REQUIRE_MESSAGE(lesson, (lesson ? "" : lesson.error().message));
    lesson->unknown_json = R"({"room":"B 12"})";
    const auto file = folder.path / "l.tactlesson.json";
    REQUIRE(write_lesson_file(file, *lesson));
    const auto again = read_lesson_file(file);
    REQUIRE_MESSAGE(again, (again ? "" : again.error().message));
    CHECK(*again == *lesson);
    CHECK(is_lesson_file(file));
    CHECK_FALSE(is_lesson_file("a.tactspace.json"));
}

TEST_CASE("lesson file: a misspelt key of the whole is refused by its name") {
    CHECK(holds(fault_of(R"({"tactlesson": 1, "set": "pm_2023_twelve", "abuot": "x",
                             "steps": [{"title": "T"}]})"),
                "l.json: /: does not know \"abuot\"; the nearest key is \"about\""));
}

TEST_CASE("lesson file: a fault is told with its file, its place and what was expected") {
    CHECK(holds(fault_of("{}"), "l.json: /tactlesson: expected"));
    CHECK(holds(fault_of(R"({"tactlesson": 1, "steps": [{}]})"), "/set: expected a set"));
    CHECK(holds(fault_of(R"({"tactlesson": 1, "set": "no such", "steps": [{}]})"),
                "comes with the program"));
    CHECK(holds(fault_of(R"({"tactlesson": 1, "set": "pm_2023_twelve"})"), "/steps"));
    CHECK(holds(fault_of(one_step(R"("pattern": "L-9")")), "/steps/0/pattern: expected the name"));
    CHECK(holds(fault_of(one_step(R"("text": "{nc | L-0-half}")")), "/steps/0/text"));
    CHECK(holds(fault_of(one_step(R"("view": "ear")")), "/steps/0/view"));
    CHECK(holds(fault_of(one_step(R"("question": {"kind": "closest"})")), "pairs"));
    CHECK(holds(fault_of(one_step(R"("question": {"kind": "receptors"})")), "pattern"));
    CHECK(holds(fault_of(one_step(R"("pattern": "L-0-half", "question": {"kind": "place"})")),
                "/steps/0/question: expected the \"view\" \"map\""));
    CHECK(holds(fault_of(one_step(R"("view": "map", "question": {"kind": "place"})")), "pattern"));
    CHECK(holds(fault_of(one_step(R"("question": {"options": ["a", "b"], "answer": 2})")),
                "/steps/0/question/answer"));
    CHECK(holds(fault_of(one_step(R"("speed": 7)")), "/steps/0/speed"));
}

TEST_CASE("lesson file: a lesson that could not be opened again is not written") {
    const TemporaryFolder folder;
    Lesson lesson = *parse_lesson(one_step(R"("title": "T")"), "l.json", {});
    lesson.steps[0].view = "nowhere";
    const auto file = folder.path / "l.tactlesson.json";
    CHECK_FALSE(write_lesson_file(file, lesson));
    CHECK_FALSE(std::filesystem::exists(file));
}

TEST_CASE("lesson file: keys of a newer version stay, in a step, its camera and its question") {
    const auto lesson = parse_lesson(one_step(R"("title": "T", "text": "t", "colour": "red",
            "camera": {"yaw_rad": 1.0, "lens": 35},
            "question": {"kind": "choice", "ask": "a", "options": ["x", "y"], "answer": 1,
                         "hint": {"after_s": 3}})"),
                                     "l.json", {});
    REQUIRE_MESSAGE(lesson, (lesson ? "" : lesson.error().message));
    const std::string written = print_lesson(*lesson, {});
    for (const char* kept : {"\"colour\": \"red\"", "\"lens\": 35", "\"after_s\": 3"}) {
        CHECK(holds(written, kept));
    }
    // Unknown keys of the question are removed with the question.
    Lesson shorter = *lesson;
    shorter.steps[0].question.reset();
    CHECK_FALSE(holds(print_lesson(shorter, {}), "hint"));
    CHECK(parse_lesson(print_lesson(shorter, {}), "again", {}));
}

TEST_CASE(
    "lesson file: texts in several languages come back, and one in the first alone is plain") {
    const char* text = R"({
  "tactlesson": 1,
  "languages": [
    "en",
    "de"
  ],
  "name": {
    "en": "Tones",
    "de": "Töne"
  },
  "about": "Five minutes",
  "set": "pm_2023_twelve",
  "steps": [
    {
      "title": {
        "en": "Low",
        "de": "Tief"
      },
      "text": "Plain",
      "note": {
        "en": "",
        "de": "Nur hier"
      },
      "question": {
        "kind": "choice",
        "ask": "Which?",
        "options": [
          "This",
          {
            "en": "That",
            "de": "Jener, {frequency | L-0-half}"
          }
        ],
        "answer": 1,
        "reveal": {
          "en": "That.",
          "de": "Jener."
        }
      }
    }
  ]
}
)";
    const auto lesson = parse_lesson(text, "l.json", {});
    REQUIRE_MESSAGE(lesson, (lesson ? "" : lesson.error().message));
    CHECK(lesson->languages == std::vector<std::string>{"en", "de"});
    CHECK(lesson->words == std::vector<LessonWords>{{"Töne", ""}});
    REQUIRE(lesson->steps[0].words.size() == 1);
    CHECK(lesson->steps[0].words[0].title == "Tief");
    CHECK(lesson->steps[0].words[0].note == "Nur hier");
    CHECK(lesson->steps[0].words[0].options ==
          std::vector<std::string>{"", "Jener, {frequency | L-0-half}"});
    CHECK(print_lesson(*lesson, {}) == text);
}

TEST_CASE("lesson file: languages that are told wrong are refused with their place") {
    const auto with = [](const std::string& languages, const std::string& title) {
        return R"({"tactlesson": 1, "languages": )" + languages +
               R"(, "set": "pm_2023_twelve", "steps": [{"title": )" + title + "}]}";
    };
    CHECK(holds(fault_of(with(R"(["en", "en"])", "\"T\"")), "/languages: expected codes"));
    CHECK(holds(fault_of(with(R"(["english"])", "\"T\"")), "/languages: expected codes"));
    CHECK(holds(fault_of(with("[3]", "\"T\"")), "/languages: expected codes"));
    CHECK(holds(fault_of(with(R"(["en"])", R"({"en": "T", "de": "X"})")),
                "/steps/0/title/de: expected a text in one of the lesson's \"languages\""));
    CHECK(holds(fault_of(with(R"(["en", "de"])", R"({"en": 3})")), "/steps/0/title/en: expected"));
    // Numbers are looked up in each language.
    CHECK(holds(fault_of(with(R"(["en", "de"])", R"({"en": "T", "de": "{nc | A | B}"})")),
                "/steps/0/title/de: expected numbers that the model can give"));
    CHECK(holds(fault_of(R"({"tactlesson": 1, "set": "pm_2023_twelve",
                             "steps": [{"title": {"en": "T"}}]})"),
                "/steps/0/title/en"));
}

}  // namespace lesson_file_test
