// A lesson in several languages: the shown texts, the language that an edit goes to, and missing
// translations.
#include "model/lesson/lesson_languages.h"

#include <doctest/doctest.h>

#include <algorithm>

namespace lesson_languages_test {

using namespace tact;

namespace {

std::shared_ptr<const Lesson> two_languages() {
    Lesson lesson;
    lesson.name = "Tones";
    lesson.languages = {"en", "de"};
    lesson.words = {{"Töne", ""}};
    lesson.about = "Five minutes";
    lesson.steps.resize(1);
    LessonStep& step = lesson.steps[0];
    step.title = "Low";
    step.text = "A tone of {frequency | A}.";
    step.question =
        LessonQuestion{QuestionKind::choice, "Which?", {"This", "That", "None"}, 1, {}, "That."};
    step.words = {{"Tief", "", "", "Welcher?", {"Dieser", "", "Keiner"}, ""}};
    return std::make_shared<const Lesson>(lesson);
}

// As the window does it: the shown step is changed, and put back.
LessonStep written(const Lesson& lesson, std::size_t place, void (*write)(LessonStep&)) {
    const auto whole = std::make_shared<const Lesson>(lesson);
    const LessonStep shown = in_language(whole, place)->steps[0];
    LessonStep after = shown;
    write(after);
    return with_words(lesson.steps[0], shown, after, place);
}

}  // namespace

TEST_CASE("languages: what is not translated shows in the first") {
    const auto lesson = two_languages();
    CHECK(in_language(lesson, 0) == lesson);
    const auto german = in_language(lesson, 1);
    CHECK(german->name == "Töne");
    CHECK(german->about == "Five minutes");
    CHECK(german->languages == std::vector<std::string>{"de"});
    const LessonStep& step = german->steps[0];
    CHECK(step.title == "Tief");
    CHECK(step.text == "A tone of {frequency | A}.");
    CHECK(step.question->ask == "Welcher?");
    CHECK(step.question->options == std::vector<std::string>{"Dieser", "That", "Keiner"});
    CHECK(step.question->answer == 1);
    CHECK(step.question->reveal == "That.");
}

TEST_CASE("languages: what is written goes to the language that is shown, and to no other") {
    const auto lesson = two_languages();
    const auto write = [](LessonStep& step) {
        step.text = "X";
        step.note = "N";
        step.question->options[1] = "Y";
    };
    const LessonStep german = written(*lesson, 1, write);
    LessonStep expected = lesson->steps[0];
    expected.words[0].text = "X";
    expected.words[0].note = "N";
    expected.words[0].options[1] = "Y";
    CHECK(german == expected);
    const LessonStep english = written(*lesson, 0, write);
    expected = lesson->steps[0];
    write(expected);
    CHECK(english == expected);
    // A step that is not edited is the same in every language.
    for (const std::size_t place : {0U, 1U}) {
        CHECK(written(*lesson, place, [](LessonStep&) {}) == lesson->steps[0]);
    }
}

TEST_CASE("languages: what is taken out of a translation shows in the first language again") {
    const auto lesson = two_languages();
    const LessonStep step = written(*lesson, 1, [](LessonStep& s) {
        s.title.clear();
        s.question->ask.clear();
        s.question->options = {"", "", ""};
    });
    CHECK(step.words.empty());
    CHECK(step.title == "Low");
    CHECK(step.question == lesson->steps[0].question);
}

TEST_CASE("languages: translations stay with their options") {
    const auto lesson = two_languages();
    const auto options_after = [&](void (*write)(LessonStep&)) {
        const LessonStep step = written(*lesson, 0, write);
        return step.words[0].options;
    };
    using Options = std::vector<std::string>;
    CHECK(options_after([](LessonStep& s) {
              s.question->options = {"This", "", "That", "None"};
          }) == Options{"Dieser", "", "", "Keiner"});
    CHECK(options_after([](LessonStep& s) {
              s.question->options = {"That", "None"};
          }) == Options{"", "Keiner"});
    CHECK(options_after([](LessonStep& s) {
              s.question->options = {"This", "That"};
          }) == Options{"Dieser"});
    CHECK(options_after([](LessonStep& s) { s.question->options[0] = "It"; }) ==
          Options{"Dieser", "", "Keiner"});
    // The first language determines their number.
    const LessonStep more =
        written(*lesson, 1, [](LessonStep& s) { s.question->options.emplace_back("Mehr"); });
    CHECK(more == lesson->steps[0]);
}

TEST_CASE("languages: view, pattern and the right answer are of no language") {
    const auto lesson = two_languages();
    const LessonStep step = written(*lesson, 1, [](LessonStep& s) {
        s.pattern = "B";
        s.view = "brain";
        s.question->answer = 2;
    });
    CHECK(step.pattern == "B");
    CHECK(step.view == "brain");
    CHECK(step.question->answer == 2);
    CHECK(step.words == lesson->steps[0].words);
    CHECK(step.text == lesson->steps[0].text);
}

TEST_CASE("languages: a language is added and removed, and nothing of the others moves") {
    Lesson lesson = *two_languages();
    const Lesson before = lesson;
    lesson = with_language(std::move(lesson), "ko");
    CHECK(lesson.languages == std::vector<std::string>{"en", "de", "ko"});
    lesson.steps[0] = written(lesson, 2, [](LessonStep& s) { s.title = "낮음"; });
    CHECK(in_language(std::make_shared<const Lesson>(lesson), 1)->steps[0].title == "Tief");
    CHECK(in_language(std::make_shared<const Lesson>(lesson), 2)->steps[0].title == "낮음");
    CHECK(without_language(lesson, 2) == before);
    const Lesson korean = without_language(lesson, 1);
    CHECK(korean.languages == std::vector<std::string>{"en", "ko"});
    CHECK(in_language(std::make_shared<const Lesson>(korean), 1)->steps[0].title == "낮음");
    CHECK(without_language(lesson, 0) == lesson);
    CHECK(with_language(Lesson{}, "de").languages == std::vector<std::string>{"en", "de"});
}

TEST_CASE("languages: what lacks is listed, and so are numbers that differ") {
    Lesson lesson = *two_languages();
    const std::vector<std::string> lacks = translation_lacks(lesson);
    REQUIRE(lacks.size() == 2);
    CHECK(lacks[0] == "The lesson: about lacks German");
    CHECK(lacks[1] ==
          "Step 1, \"Low\": text, what is said with the answer and option 2 lack German");
    lesson.words[0].about = "Fünf Minuten";
    StepWords& words = lesson.steps[0].words[0];
    words.text = "Ein Ton von {amplitude | A}.";
    words.reveal = "Jener.";
    words.options[1] = "Jener";
    const std::vector<std::string> differ = translation_lacks(lesson);
    REQUIRE(differ.size() == 1);
    CHECK(differ[0] ==
          "Step 1, \"Low\": text in German has the numbers {amplitude | A}, the first language "
          "{frequency | A}");
    words.text = "{frequency | A} hat der Ton.";  // wherever they stand
    CHECK(translation_lacks(lesson).empty());
}

TEST_CASE("languages: numbers of every language are asked of the model") {
    Lesson lesson = *two_languages();
    lesson.steps[0].words[0].text = "Um {amplitude | A}.";
    const auto texts = texts_of(lesson.steps[0]);
    CHECK(std::ranges::find(texts, "Um {amplitude | A}.") != texts.end());
    CHECK(std::ranges::find(texts, "Keiner") != texts.end());
}

TEST_CASE("languages: codes are those of BCP 47, and every one of the list is one") {
    for (const NamedLanguage& one : kNamedLanguages) {
        CHECK(is_language_code(one.code));
        CHECK(language_name(one.code) == one.name);
    }
    for (const char* good : {"pt-BR", "zh-Hant", "gsw", "sr-Latn-RS"})
        CHECK(is_language_code(good));
    for (const char* bad : {"", "e", "engl", "en-", "-de", "e1", "en_US", "en US"})
        CHECK_FALSE(is_language_code(bad));
    CHECK(language_name("gsw") == "gsw");
}

}  // namespace lesson_languages_test
