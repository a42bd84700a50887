// No edit of a lesson is lost: it is in the autosave, asked about, or saved, complete or not.
#include "app/lesson/lesson.h"

#include <doctest/doctest.h>

#include "app/document/editing.h"
#include "app/window/window.h"
#include "model/io/lesson/lesson_file.h"
#include "model/lesson/lesson_lacks.h"
#include "tests/support/lesson_class.h"
#include "tests/support/scene_steps.h"
#include "tests/support/temporary_folder.h"

namespace lesson_keeping_test {

using namespace tact;
namespace fs = std::filesystem;

namespace {

// An author of a lesson of four steps, in a session of its own.
struct Writing : Class {
    TemporaryFolder folder;

    Writing() {
        app.work.session = open_session(folder.path / "state");
        resize({1600.0F, 2400.0F}, 1.0F);
    }
    ~Writing() { (void)close_session(app.work.session); }

    void write_four() {
        new_lesson(lesson_context(app), app.lesson);
        for (int k = 1; k < 4; ++k) add_step(lesson_context(app), app.lesson);
        for (std::size_t k = 0; k < 4; ++k) {
            go_to_step(lesson_context(app), app.lesson, k);
            LessonStep step = *step_of(app.lesson);
            step.text = "What step " + std::to_string(k + 1) + " says";
            change_step(lesson_context(app), app.lesson, step, "Text", true);
        }
        settle();
    }
    fs::path file() const { return lesson_autosave(app.work.session.autosave); }
    std::string step_title() const { return step_of(app.lesson)->title; }
    std::vector<LessonStep> steps() const { return app.lesson.lesson->steps; }
    // Leaves the program as if it was killed.
    RestoredLesson after_kill() const {
        Session later = app.work.session;
        return restore_lesson(later);
    }
    void wait_for_autosave_of_lesson() {
        wait_until(*this, [&] {
            return fs::exists(file()) && !is_autosaving(app.lesson) && !app.lesson.keep_pending;
        });
    }
    std::vector<LessonStep> steps_of_recent() const {
        const auto& recent = app.work.session.recent_files;
        if (recent.empty() || !is_lesson_file(recent[0])) return {};
        const auto lesson = read_lesson_file(recent[0]);
        return lesson ? lesson->steps : std::vector<LessonStep>{};
    }
};

}  // namespace

TEST_CASE("lesson kept: Esc ends no lesson that is being written, however often") {
    Writing program;
    program.write_four();
    const auto written = program.steps();
    for (int k = 0; k < 3; ++k) program.press_key(key::kEscape);
    REQUIRE(program.lesson().step);
    CHECK(program.lesson().editing);
    CHECK(program.steps() == written);
    program.click("lesson edit:title");
    program.type("more");
    program.press_key(key::kEscape);
    CHECK(program.step_title().find("more") != std::string::npos);
}

TEST_CASE("lesson kept: a second after the last word it survives a kill, for this user alone") {
    Writing program;
    program.write_four();
    program.wait_for_autosave_of_lesson();
    const RestoredLesson restored = program.after_kill();
    REQUIRE(restored.draft);
    CHECK(restored.draft->lesson.steps == program.steps());
    CHECK(restored.draft->step == 3);
    CHECK((fs::status(program.file()).permissions() &
           (fs::perms::group_all | fs::perms::others_all)) == fs::perms::none);

    Class next;
    resume_lesson(lesson_context(next.app), next.lesson(), *restored.draft);
    next.settle();
    CHECK(next.at("tour").value == "4 of 4");
    CHECK(next.lesson().editing);
    CHECK_FALSE(next.lesson().aside);  // the set is the open one
    CHECK(unsaved_lesson(next.app.work, next.lesson()));
}

TEST_CASE("lesson kept: leaving, the tour, another lesson and a new one ask; the draft is kept") {
    for (const char* command :
         {"Leave the lesson", "Guided tour", kBundledLessons[2].name, "New lesson from this set"}) {
        CAPTURE(command);
        Writing program;
        program.write_four();
        const auto written = program.steps();
        run(program, command);
        REQUIRE(program.shows("answer:Keep a draft"));
        program.click("answer:Cancel");
        CHECK(program.steps() == written);
        run(program, command);
        program.click("answer:Keep a draft");
        CHECK((!program.lesson().step || program.steps() != written));
        CHECK(program.steps_of_recent() == written);
        CHECK_FALSE(fs::exists(program.file()));
    }
}

TEST_CASE("lesson kept: a set that takes the document's place leaves the draft with its own set") {
    Writing program;
    program.write_four();
    const auto written = program.steps();
    open_example(program.app.ui, program.app.work);
    program.settle();
    CHECK_FALSE(program.lesson().step);
    CHECK(program.steps_of_recent() == written);
    const auto kept = read_lesson_file(program.app.work.session.recent_files.at(0));
    REQUIRE(kept);
    CHECK(kept->set == short_patterns(3));
}

TEST_CASE("lesson kept: the program closes with it kept, says so once, and Cancel leaves nothing") {
    Writing program;
    program.write_four();
    const auto written = program.steps();
    quit(program.app);
    program.settle();
    REQUIRE(program.shows("answer:Quit"));
    program.click("answer:Cancel");
    CHECK_FALSE(program.app.ui.quit);
    CHECK(program.steps() == written);
    quit(program.app);
    program.settle();
    program.click("answer:Quit");
    CHECK(program.app.ui.quit);
    const RestoredLesson restored = program.after_kill();
    REQUIRE(restored.draft);
    CHECK(restored.draft->lesson.steps == written);
    CHECK(program.app.work.session.recent_files.empty());  // no second copy
}

TEST_CASE("lesson kept: what cannot be kept stays, and says why") {
    Writing program;
    program.write_four();
    const auto written = program.steps();
    program.app.work.session.folder = "/proc/self";
    program.app.work.session.autosave = "/proc/self/autosave.json";
    CHECK_FALSE(leave_lesson(lesson_context(program.app), program.lesson()));
    CHECK(program.app.ui.status.is_error);
    CHECK(program.steps() == written);
    CHECK_FALSE(may_close(program.app));
}

TEST_CASE("lesson kept: an unfinished lesson is saved as a draft, and told what it lacks") {
    Writing program;
    program.write_four();
    LessonStep step = *step_of(program.lesson());
    step.text = "Of {nc | p1 | nobody}";
    step.question = LessonQuestion{QuestionKind::choice, "Which?", {"This"}, 0, {}, {}};
    change_step(lesson_context(program.app), program.lesson(), step, "Question");
    program.settle();
    const fs::path file = program.folder.path / "mine.tactlesson.json";
    CHECK(save_lesson(program.app.ui, program.app.work, program.lesson(), file));
    CHECK(program.app.ui.status.text.find("draft") != std::string::npos);
    CHECK_FALSE(unsaved_lesson(program.app.work, program.lesson()));
    const auto again = read_lesson_file(file);
    REQUIRE_MESSAGE(again, (again ? "" : again.error().message));
    CHECK(again->steps == program.steps());
    CHECK(lesson_lacks(*again).size() == 2);
    // A class never sees a question that cannot be answered. Numbers that arrive move the rows
    // below them.
    program.wait_for_numbers();
    program.click("lesson edit:check");
    REQUIRE(program.app.ui.question);
    CHECK(program.app.ui.question->text.find("nobody") != std::string::npos);
    program.app.ui.question.reset();
    toggle_editing(lesson_context(program.app), program.lesson());
    program.wait_for_numbers();
    CHECK_FALSE(program.shows("option:1"));
    program.press_key(key::kPageUp);
    CHECK(program.lesson().step == 2U);
}

TEST_CASE("lesson kept: a whole lesson is no draft, and is unsaved again with the next letter") {
    Writing program;
    program.write_four();
    const fs::path file = program.folder.path / "mine.tactlesson.json";
    REQUIRE(save_lesson(program.app.ui, program.app.work, program.lesson(), file));
    CHECK(bytes_of(file).find("\"draft\"") == std::string::npos);
    CHECK(program.app.work.session.recent_files.at(0) == file);
    CHECK(leave_lesson(lesson_context(program.app), program.lesson()));
    CHECK(program.app.work.session.recent_files.size() == 1);
    open_lesson(lesson_context(program.app), program.lesson(), file);
    program.settle();
    toggle_editing(lesson_context(program.app), program.lesson());
    program.settle();
    CHECK_FALSE(unsaved_lesson(program.app.work, program.lesson()));
    program.click("lesson edit:title");
    program.type("x");
    CHECK(unsaved_lesson(program.app.work, program.lesson()));
    undo_lesson(lesson_context(program.app), program.lesson());
    CHECK_FALSE(unsaved_lesson(program.app.work, program.lesson()));
}

TEST_CASE("lesson kept: every edit is undone and done again, a pattern renamed in between too") {
    Writing program;
    new_lesson(lesson_context(program.app), program.lesson());
    const auto first = program.steps();
    for (int k = 0; k < 3; ++k) add_step(lesson_context(program.app), program.lesson());
    LessonStep step = *step_of(program.lesson());
    step.question = LessonQuestion{QuestionKind::closest, "?", {}, 0, {{"p1", "p2"}}, {}};
    change_step(lesson_context(program.app), program.lesson(), step, "Question");
    move_step(lesson_context(program.app), program.lesson(), -1);
    remove_step(lesson_context(program.app), program.lesson());
    take_camera(lesson_context(program.app), program.lesson(), true);
    show_screen(lesson_context(program.app), program.lesson());
    program.settle();
    auto last = program.steps();
    rename_vibration(program.app.ui, program.app.work, 0, "one");
    program.settle();
    for (LessonStep& one : last) {
        if (one.pattern == "p1") one.pattern = "one";
        if (one.question) one.question->pairs = {{"one", "p2"}};
    }
    CHECK(program.steps() == last);
    while (program.lesson().history.undo_label() != nullptr)
        undo_lesson(lesson_context(program.app), program.lesson());
    CHECK(program.steps().size() == first.size());
    CHECK(program.steps()[0].pattern == "one");
    while (program.lesson().history.redo_label() != nullptr)
        redo_lesson(lesson_context(program.app), program.lesson());
    CHECK(program.steps() == last);
}

TEST_CASE(
    "lesson kept: a map that was turned round and brought near is a camera that can be saved") {
    Writing program;
    program.app.shown_map.camera.yaw_rad = 40.0;
    program.app.shown_map.camera.zoom = 39.0;
    program.app.layout.maximised = Pane::space;
    new_lesson(lesson_context(program.app), program.lesson());
    program.settle();
    const fs::path file = program.folder.path / "near.tactlesson.json";
    CHECK(save_lesson(program.app.ui, program.app.work, program.lesson(), file));
    const auto again = read_lesson_file(file);
    REQUIRE_MESSAGE(again, (again ? "" : again.error().message));
    CHECK(std::sin(again->steps[0].camera->yaw_rad) == doctest::Approx(std::sin(40.0)));
    CHECK(again->steps[0].camera->zoom == 39.0);
}

}  // namespace lesson_keeping_test
