// F5 presents the running lesson, or the person's own set; a lesson continues where it was left;
// and the parts that a class may see.
#include <doctest/doctest.h>

#include "app/lesson/lesson.h"
#include "app/physiology/physiology.h"
#include "app/report/report.h"
#include "app/window/app.h"
#include "assets/assets.h"
#include "model/io/lesson/lesson_file.h"
#include "model/lesson/lesson_languages.h"
#include "tests/support/lesson_class.h"
#include "tests/support/scene_steps.h"
#include "tests/support/temporary_folder.h"

namespace lesson_presenting_test {

using namespace tact;

namespace {

constexpr int kF5 = key::kF1 + 4;

std::string told_to_class(const std::string& source) {
    LessonStep step;
    step.source = source;
    return source_for_class(step);
}

}  // namespace

TEST_CASE("F5: with no lesson open it shows the open set, a step for the map and one a pattern") {
    Class program;
    program.app.work.document.edit().vibrations[1].dropped = true;
    document_changed(program.app.work);
    program.settle();
    program.wait_for_exact_map();
    const PatternSet before = program.app.work.document.set;
    const auto revision = program.app.work.revision;
    const auto map = program.app.shown_map.transition.shown;
    program.press_key(kF5);
    REQUIRE(is_presenting(program.lesson()));
    CHECK_FALSE(program.lesson().aside);  // the shown set is the document itself
    CHECK(program.lesson().shown->set.vibrations.empty());
    CHECK(program.at("tour").value == "1 of 3");
    CHECK(program.shows("pane:Perceptual space"));
    CHECK_FALSE(program.shows("menu:File"));
    program.press_key(key::kPageDown);
    CHECK(program.shows("pane:Physiology"));
    CHECK(current_vibration(program.app.work)->name == "p1");
    program.press_key(key::kPageDown);
    CHECK(current_vibration(program.app.work)->name == "p3");
    CHECK(program.app.work.revision == revision);  // the map is not computed again
    CHECK(program.app.shown_map.transition.shown == map);
    CHECK_FALSE(unsaved_lesson(program.app.work, program.lesson()));
    program.press_key(kF5);
    CHECK_FALSE(program.lesson().step);
    CHECK(program.shows("menu:File"));
    CHECK(program.app.work.document.set == before);
    CHECK(program.lesson().left_at.empty());
    program.press_key(kF5);
    program.press_key(key::kEscape);
    CHECK_FALSE(program.lesson().step);
}

TEST_CASE("F5: a lesson under way is shown where it is") {
    Class program;
    program.begin(kBundledLessons[0].path);
    go_to_step(lesson_context(program.app), program.lesson(), 2);
    program.press_key(kF5);
    CHECK(program.lesson().step == 2U);
    CHECK_FALSE(program.app.ui.question);
    CHECK(is_presenting(program.lesson()));
}

TEST_CASE("F5: an empty document shows the tour, which asks where it was left") {
    Program program{PatternSet{}};
    program.press_key(kF5);
    REQUIRE(program.app.lesson.is_tour);
    CHECK_FALSE(program.app.ui.question);
    go_to_step(lesson_context(program.app), program.app.lesson, 4);
    program.press_key(key::kEscape);
    program.press_key(kF5);
    REQUIRE(program.app.ui.question);
    CHECK(program.app.ui.question->text.find("step 5 of 19") != std::string::npos);
    CHECK(program.app.lesson.step == 0U);
    program.press_key(key::kEnter);  // a new lecture starts at the first step
    CHECK(program.app.lesson.step == 0U);
    program.press_key(key::kEscape);
    CHECK(program.app.lesson.left_at.empty());  // left at its first step
}

TEST_CASE(
    "a lesson that was left half way asks where to begin; one that came to its end does not") {
    Class program;
    const char* name = kBundledLessons[0].name;
    run(program, name);
    go_to_step(lesson_context(program.app), program.lesson(), 2);
    program.settle();
    run(program, "Leave the lesson");
    run(program, name);
    REQUIRE(program.shows("answer:Continue at step 3"));
    program.click("answer:Continue at step 3");
    CHECK(program.lesson().step == 2U);
    go_to_step(lesson_context(program.app), program.lesson(),
               program.lesson().lesson->steps.size() - 1);
    run(program, "Leave the lesson");
    run(program, name);
    CHECK_FALSE(program.app.ui.question);
    CHECK(program.lesson().step == 0U);
}

TEST_CASE("a duplicate is an unsaved copy, of a lesson that comes with the program, too") {
    const TemporaryFolder folder;
    Class program;
    program.app.work.session = open_session(folder.path / "state");
    run(program, kBundledLessons[0].name);
    const Lesson original = *program.lesson().lesson;
    run(program, "Duplicate the lesson");
    CHECK(program.lesson().lesson->name == original.name + " copy");
    CHECK(program.lesson().lesson->steps == original.steps);
    CHECK(program.lesson().path.empty());
    CHECK(program.lesson().editing);
    CHECK(unsaved_lesson(program.app.work, program.lesson()));
    const auto file = folder.path / "mine.tactlesson.json";
    REQUIRE(save_lesson(program.app.ui, program.app.work, program.lesson(), file));
    CHECK_FALSE(unsaved_lesson(program.app.work, program.lesson()));
    CHECK(read_lesson_file(file)->set == original.set);
    (void)close_session(program.app.work.session);
}

TEST_CASE("what is handed on has notes, answers, and a lesson that needs no other file") {
    Lesson lesson = *bundled_lesson(kBundledLessons[4].path);
    lesson.set_name = "pm_2023_twelve";  // from a file without a set of its own
    lesson.steps[0].note = "For who speaks";
    const LessonAnswers answers = lesson_answers(lesson, {}, false);
    const auto file = whole_lesson_file(lesson);
    REQUIRE(file);
    const auto again = parse_lesson(*file, "lesson", {});
    REQUIRE(again);
    CHECK(again->set_name.empty());
    CHECK(again->set == lesson.set);
    CHECK(again->steps == lesson.steps);
    LessonSheet sheet{lesson, answers};
    const std::string student = lesson_sheet(sheet);
    sheet.lesson_file = *file;
    const std::string teacher = lesson_sheet(sheet);
    CHECK(student.find("For who speaks") == std::string::npos);
    CHECK(student.find("base64") == std::string::npos);
    CHECK(teacher.find("For who speaks") != std::string::npos);
    CHECK(teacher.find("base64," + base64(*file)) != std::string::npos);
    CHECK(teacher.find("Name: <span") == std::string::npos);
    lesson.set.vibrations[0].source = Measurement{std::make_shared<Waveform>(), "a.wav", 1.0, {}};
    const auto refused = whole_lesson_file(lesson);
    REQUIRE_FALSE(refused);
    CHECK(refused.error().message.find("is a recording") != std::string::npos);
}

TEST_CASE("nothing that a class sees says that its author has not looked it up") {
    CHECK(told_to_class("Helmholtz 1863 (not looked up); sin a + sin b") == "sin a + sin b");
    CHECK(told_to_class("Talbot 1968 (not looked up)").empty());
    CHECK(told_to_class("Saal 2017, Table 2") == "Saal 2017, Table 2");
    int lessons = 0;
    for (const Asset& file : assets()) {
        if (!file.path.starts_with("lessons/") || !is_lesson_file(file.path)) continue;
        ++lessons;
        CAPTURE(file.path);
        const auto whole = std::make_shared<const Lesson>(*parse_lesson(file.text, "lesson", {}));
        for (std::size_t k = 0; k < std::max<std::size_t>(1, whole->languages.size()); ++k) {
            const auto lesson = in_language(whole, k);
            const LessonAnswers answers = lesson_answers(*lesson, {}, false);
            const std::string sheet = lesson_sheet({*lesson, answers});
            CHECK(sheet.find("not looked up") == std::string::npos);
            for (const LessonStep& step : lesson->steps) {
                CHECK(source_for_class(step).find("not looked up") == std::string::npos);
                for (const std::string& text : texts_of(step)) {
                    CHECK(text.find("not looked up") == std::string::npos);
                }
            }
        }
    }
    CHECK(lessons > kBundledLessons.size());
    for (const Stage stage : kStages) {
        CAPTURE(text_of(stage).name);
        CHECK(std::string(text_of(stage).source).find("looked up") == std::string::npos);
    }
    // The author sees it on the card, and the class does not.
    Class program;
    new_lesson(lesson_context(program.app), program.lesson());
    LessonStep step = *step_of(program.lesson());
    step.source = "Talbot 1968 (not looked up)";
    change_step(lesson_context(program.app), program.lesson(), step, "Source");
    program.settle();
    CHECK(program.shows("lesson:source"));
    toggle_editing(lesson_context(program.app), program.lesson());
    program.settle();
    CHECK_FALSE(program.shows("lesson:source"));
}

TEST_CASE("each edit of a lesson is undone to what was before, and done again to what came of it") {
    Class program;
    const LessonContext context = lesson_context(program.app);
    LessonState& state = program.lesson();
    const auto edit_step = [&](void (*edit)(LessonStep&)) {
        return [&, edit] {
            LessonStep step = *step_of(state);
            edit(step);
            change_step(context, state, step, "Something");
        };
    };
    const auto edit_question = [&](void (*edit)(LessonQuestion&)) {
        return [&, edit] {
            LessonStep step = *step_of(state);
            edit(*step.question);
            change_step(context, state, step, "Something");
        };
    };
    const std::vector<std::function<void()>> edits{
        [&] {
            change_name(context, state, {"Name", "About"});
        },
        edit_step([](LessonStep& s) { s.title = "T"; }),
        edit_step([](LessonStep& s) { s.text = "{nc | p1 | p2}"; }),
        edit_step([](LessonStep& s) { s.note = "N"; }),
        edit_step([](LessonStep& s) { s.source = "S"; }),
        edit_step([](LessonStep& s) { s.point_at = "grid FA2"; }),
        edit_step([](LessonStep& s) { s.view = "map"; }),
        [&] { take_camera(context, state, true); },
        [&] { take_camera(context, state, false); },
        edit_step([](LessonStep& s) { s.question.emplace(); }),
        edit_question([](LessonQuestion& q) { q.ask = "Q"; }),
        edit_question([](LessonQuestion& q) {
            q.options = {"A", "B"};
        }),
        edit_question([](LessonQuestion& q) { q.answer = 1; }),
        edit_question([](LessonQuestion& q) { q.reveal = "R"; }),
        edit_question([](LessonQuestion& q) { q.kind = QuestionKind::closest; }),
        edit_question([](LessonQuestion& q) {
            q.pairs = {{"p1", "p2"}, {"p1", "p3"}};
        }),
        [&] { add_language(context, state, "de"); },
        [&] {
            change_name(context, state, {"Deutsch", "Name"});
        },
        edit_step([](LessonStep& s) { s.text = "Deutsch"; }),
        edit_step([](LessonStep& s) { s.question.reset(); }),
        [&] { add_step(context, state); },
        [&] { move_step(context, state, 1); },
        [&] { show_screen(context, state); },
        [&] { remove_step(context, state); },
        [&] { remove_language(context, state); }};
    new_lesson(context, state);
    for (std::size_t k = 0; k < edits.size(); ++k) {
        CAPTURE(k);
        program.app.timeline.range = {0.01, 0.02 + 0.001 * static_cast<double>(k)};
        program.app.shown_map.camera.yaw_rad = 0.1 * static_cast<double>(k);
        const Lesson before = *state.lesson;
        const std::size_t steps_of_undo = state.history.size();
        edits[k]();
        const Lesson after = *state.lesson;
        CHECK(after != before);
        CHECK(state.history.size() == steps_of_undo + 1);
        undo_lesson(context, state);
        CHECK(*state.lesson == before);
        redo_lesson(context, state);
        CHECK(*state.lesson == after);
        // A file of the lesson has the same steps.
        CHECK(parse_lesson(print_lesson(after, {}), "lesson", {})->steps == after.steps);
        program.settle();
    }
}

TEST_CASE("the language that is chosen is shown, written in, and kept for other lessons") {
    Class program;
    const LessonContext context = lesson_context(program.app);
    new_lesson(context, program.lesson());
    program.settle();
    add_language(context, program.lesson(), "de");
    program.settle();
    CHECK(program.lesson().language == "de");
    program.click("lesson edit:title");
    program.press('a', true);
    program.type("Gross");
    program.click("lesson edit:note");
    CHECK(step_of(program.lesson())->title == "Gross");
    CHECK(program.lesson().lesson->steps[0].title == "New step");
    CHECK(program.lesson().lesson->steps[0].words.at(0).title == "Gross");
    program.click("menu:Lesson");
    program.click("menu:Language");
    program.click("language:en");
    CHECK(step_of(program.lesson())->title == "New step");
    check_lesson(program.app.ui, program.app.work, program.lesson());
    REQUIRE(program.app.ui.question);
    CHECK(program.app.ui.question->text.find("lack") != std::string::npos);
    CHECK(program.app.ui.question->text.find("German") != std::string::npos);
}

TEST_CASE("letters that no font here has are told with the package that has them") {
    Class program;
    const LessonContext context = lesson_context(program.app);
    new_lesson(context, program.lesson());
    const auto write = [&](const char* text) {
        LessonStep step = *step_of(program.lesson());
        step.text = text;
        change_step(context, program.lesson(), step, "Text");
        if (program.lesson().editing) toggle_editing(context, program.lesson());
        for (int k = 0; k < 4; ++k) {
            program.settle();
            remake_fonts(program);
        }
    };
    write("Größe, 0,5 µm");
    CHECK_FALSE(program.shows("lesson:lacking"));
    write("\U0000E9A5");  // private use: no font has a shape for it
    CHECK(program.at("lesson:lacking").value.find("package") != std::string::npos);
    CHECK(package_for(U"한국어") == std::string("The package fonts-nanum"));
    CHECK(package_for(U"한日") == std::string("The package fonts-noto-cjk"));
}

}  // namespace lesson_presenting_test
