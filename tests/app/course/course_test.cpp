// A course: whose progress is kept, what counts as an answer, and the way on.
#include <doctest/doctest.h>

#include <filesystem>

#include "app/course/course.h"
#include "app/lesson/lesson.h"
#include "model/io/lesson/course_file.h"
#include "tests/support/lesson_class.h"
#include "tests/support/scene_steps.h"
#include "tests/support/temporary_folder.h"

namespace course_test {

using namespace tact;
namespace fs = std::filesystem;

namespace {

struct Learning : Class {
    TemporaryFolder folder;

    Learning() {
        app.work.session = open_session(folder.path / "state");
        run(*this, "Course of all lessons");
    }
    ~Learning() { (void)close_session(app.work.session); }

    fs::path file() const { return progress_file(app.work.session); }
    std::string stands(std::size_t lesson) {
        return at("course:lesson:" + std::to_string(lesson)).value;
    }
    void write_name(const std::string& name) {
        app.course.student = name;
        settle();
    }
    // The second of them asks something at its second step.
    void answer_one(bool right) {
        begin_course_lesson(lesson_context(app), app.lesson, app.course, 1);
        app.ui.dialog = kNoDialog;
        settle();
        wait_for_numbers();
        go_to_question();
        const auto& asked = answers_of(app.lesson)->questions[*app.lesson.step];
        std::size_t option = 0;
        while ((std::ranges::find(asked.right, option) != asked.right.end()) != right) ++option;
        REQUIRE(vote(app.lesson, option));
        press_key(key::kPageDown);
    }
};

}  // namespace

TEST_CASE("course: its cover lists the lessons, and begins the first that is not finished") {
    Learning program;
    REQUIRE(program.shows("course:lesson:7"));
    program.write_name("Ada");
    CHECK(program.stands(1) == "not begun");
    CHECK(next_lesson(program.app.course) == 0U);
    program.click("button:choose");
    program.settle();
    CHECK(program.lesson().is_tour);
    CHECK(program.lesson().step == 0U);
    program.press_key(key::kPageDown);
    CHECK(program.app.course.progress["Ada"][kTourLesson].reached == 2);
    program.press_key(key::kEscape);
    program.settle();
    CHECK(program.stands(1) == "at step 2 of 19");  // the cover is there again
    begin_course_lesson(lesson_context(program.app), program.lesson(), program.app.course, 0);
    CHECK(program.lesson().step == 1U);
    CHECK_FALSE(program.app.ui.question);  // it was just said where
}

TEST_CASE("course: an answer given alone is kept under the student's name, the first one alone") {
    Learning program;
    program.write_name("Ada");
    program.answer_one(true);
    const std::string lesson = program.app.course.lessons[1].key;
    const LessonProgress& progress = program.app.course.progress["Ada"][lesson];
    REQUIRE(progress.answers.size() == 1);
    CHECK(progress.answers.begin()->second.right);
    CHECK_FALSE(progress.answers.begin()->second.question.empty());
    const auto kept = read_progress(program.file());
    REQUIRE(kept);
    CHECK(*kept == program.app.course.progress);
    CHECK((fs::status(program.file()).permissions() &
           (fs::perms::group_all | fs::perms::others_all)) == fs::perms::none);
    // Another student has a progress of their own.
    program.app.course.student = "Bo";
    CHECK(progress_of(program.app.course, program.app.course.lessons[1]) == nullptr);
    // A second try changes nothing.
    program.app.course.student = "Ada";
    leave_lesson(lesson_context(program.app), program.lesson());
    program.answer_one(false);
    CHECK(program.app.course.progress["Ada"][lesson].answers.begin()->second.right);
    const auto csv = program.folder.path / "answers.csv";
    export_answers(program.app.ui, program.app.course, csv);
    CHECK(bytes_of(csv).find("Ada,thresholds,") != std::string::npos);
}

TEST_CASE("course: nothing is kept without a name, and nothing of what a class says") {
    {
        Learning program;
        program.answer_one(true);
        CHECK_FALSE(fs::exists(program.file()));
        CHECK(program.app.course.progress.empty());
    }
    Learning program;
    program.write_name("Ada");
    begin_course_lesson(lesson_context(program.app), program.lesson(), program.app.course, 1);
    program.app.ui.dialog = kNoDialog;
    toggle_presenting(lesson_context(program.app), program.lesson());
    program.settle();
    CHECK_FALSE(fs::exists(program.file()));
}

TEST_CASE("course: a file of one's own, with a lesson that is not there") {
    Learning program;
    const auto file = program.folder.write(
        "mine.tactcourse.json",
        R"({"tactcourse": 1, "name": "Mine", "lessons": ["beats", "no.tactlesson.json"]})");
    program.app.ui.dialog = kNoDialog;
    open_course_file(program.app.ui, program.app.work.session, program.app.course, file);
    program.settle();
    CHECK(program.app.course.lessons[0].lesson);
    CHECK_FALSE(program.app.course.lessons[1].lesson);
    CHECK(program.stands(2) == "cannot be read");
    CHECK(program.app.work.session.recent_files.at(0) == file);
    program.folder.write("bad.tactcourse.json", "{}");
    open_course_file(program.app.ui, program.app.work.session, program.app.course,
                     program.folder.path / "bad.tactcourse.json");
    CHECK(program.app.ui.status.is_error);
    CHECK(program.app.course.course->name == "Mine");  // the open one stays
}

TEST_CASE("course: what was kept and cannot be read is told, and stays as it is") {
    Class program;
    const TemporaryFolder folder;
    program.app.work.session = open_session(folder.path / "state");
    const auto file = folder.write("state/students.json", "{broken");
    run(program, "Course of all lessons");
    CHECK(program.app.ui.status.is_error);
    program.app.course.student = "Ada";
    begin_course_lesson(lesson_context(program.app), program.lesson(), program.app.course, 0);
    program.app.ui.dialog = kNoDialog;
    program.settle();
    CHECK(bytes_of(file) == "{broken");
    (void)close_session(program.app.work.session);
}

}  // namespace course_test
