// Questions, cameras and the order of steps, edited in the program and undone.
#include <doctest/doctest.h>

#include "app/lesson/lesson.h"
#include "model/io/lesson/lesson_file.h"
#include "tests/support/lesson_class.h"
#include "tests/support/temporary_folder.h"

namespace lesson_writing_test {

using namespace tact;

namespace {

struct Writing : Class {
    Writing() {
        resize({1600.0F, 2400.0F}, 1.0F);
        new_lesson(lesson_context(app), app.lesson);
        settle();
    }

    const LessonStep& step() { return app.lesson.lesson->steps[*app.lesson.step]; }

    void choose_kind(const char* kind) {
        click("lesson edit:kind");
        click(std::string("lesson edit:kind:") + kind);
    }

    void write(const char* field, const std::string& text) {
        click(std::string("lesson edit:") + field);
        type(text);
        click("lesson edit:title");  // Esc would undo it
    }
};

}  // namespace

TEST_CASE("writing a lesson: a question with its options and the right one, opened again") {
    const TemporaryFolder folder;
    const auto file = folder.path / "mine.tactlesson.json";
    Writing program;
    CHECK_FALSE(program.shows("lesson edit:ask"));
    program.choose_kind("choice");
    REQUIRE(program.step().question);
    CHECK(program.shows("lesson edit:fault"));  // no options yet
    program.write("ask", "Which?");
    LessonStep step = program.step();
    step.question->options = {"This", "That"};
    change_step(lesson_context(program.app), program.lesson(), step, "Options");
    program.settle();
    CHECK_FALSE(program.shows("lesson edit:fault"));
    program.click("lesson edit:right:2");
    CHECK(program.step().question->ask == "Which?");
    CHECK(program.step().question->answer == 1);
    program.wait_for_numbers();
    CHECK(program.at("option:2").value == "0 right");
    save_lesson(program.app.ui, program.app.work, program.lesson(), file);
    CHECK_FALSE(program.app.ui.status.is_error);
    const auto again = read_lesson_file(file);
    REQUIRE_MESSAGE(again, (again ? "" : again.error().message));
    CHECK(again->steps[0].question == program.step().question);
}

TEST_CASE("writing a lesson: Up and Down stand beside each other, however narrow the card") {
    Writing program;
    for (const float share : {0.15F, 0.2F, 0.24F, 0.3F, 0.4F}) {
        CAPTURE(share);
        program.lesson().card_share = share;
        program.settle();
        CHECK(program.at("lesson edit:up").min.y == program.at("lesson edit:down").min.y);
        CHECK(program.at("lesson edit:down").max.x <= program.at("tour").max.x);
    }
}

TEST_CASE("writing a lesson: pairs are those on screen, and answered by the model") {
    Writing program;
    program.choose_kind("closest");
    CHECK(program.shows("lesson edit:fault"));
    for (const char* partner : {"p2", "p3"}) {
        program.app.work.selection.pinned = partner;
        program.settle();
        program.click("lesson edit:add pair");
    }
    const auto& pairs = program.step().question->pairs;
    REQUIRE(pairs.size() == 2);
    CHECK(pairs[0] == PatternPair{"p1", "p2"});
    CHECK(pairs[1] == PatternPair{"p1", "p3"});
    CHECK_FALSE(program.shows("lesson edit:fault"));
    program.click("lesson edit:remove pair:1");
    CHECK(program.step().question->pairs.size() == 1);
}

TEST_CASE("writing a lesson: the map's camera is taken from the screen, and left again") {
    Writing program;
    program.app.layout.maximised = Pane::space;
    program.settle();
    program.app.shown_map.camera.yaw_rad = 1.25;
    program.app.layout.maximised.reset();
    LessonStep step = program.step();
    step.view = "map";
    change_step(lesson_context(program.app), program.lesson(), step, "View");
    program.settle();
    program.click("lesson edit:camera");
    REQUIRE(program.step().camera);
    CHECK(program.step().camera->yaw_rad == 1.25);
    program.click("lesson edit:no camera");
    CHECK_FALSE(program.step().camera);
}

TEST_CASE("writing a lesson: Ctrl+Z takes back what was written, and the document's after that") {
    Writing program;
    program.click("lesson edit:add");
    CHECK(program.lesson().lesson->steps.size() == 2);
    program.choose_kind("receptors");
    REQUIRE(program.step().question);
    program.press('z', true);
    CHECK_FALSE(program.step().question);
    program.press('z', true);
    CHECK(program.lesson().lesson->steps.size() == 1);
    program.press('z', true, true);
    CHECK(program.lesson().lesson->steps.size() == 2);
    // The document changed since, so Ctrl+Z undoes its last edit.
    const auto before = program.app.work.document.set;
    edit_patterns(program.app.work, [](Pattern& p) { p.amplitude_g = 0.25; });
    commit_step(program.app.ui, program.app.work, "Change amplitude");
    program.settle();
    program.press('z', true);
    CHECK(program.app.work.document.set == before);
    CHECK(program.lesson().lesson->steps.size() == 2);
    program.click("lesson edit:undo");
    CHECK(program.lesson().lesson->steps.size() == 1);
}

TEST_CASE("writing a lesson: letters of one text are one step of undo") {
    Writing program;
    program.write("note", "slowly");
    CHECK(program.step().note == "slowly");
    program.click("lesson edit:undo");
    CHECK(program.step().note.empty());
    CHECK_FALSE(program.shows("lesson edit:undo"));
}

TEST_CASE("writing a lesson: Alt with Page Up and Page Down moves the step") {
    Writing program;
    program.app.physiology.view.open = Stage::spikes;
    program.settle();
    program.click("lesson edit:add");
    CHECK(program.lesson().step == 1U);
    const auto alt = [&](int code) {
        push(program.window.input,
             {program.window.now_s, KeyChange{key::kLeftAlt, true, false, 0}});
        program.press_key(code);
        push(program.window.input,
             {program.window.now_s, KeyChange{key::kLeftAlt, false, false, 0}});
        program.settle();
    };
    alt(key::kPageUp);
    CHECK(program.lesson().step == 0U);
    CHECK(program.lesson().lesson->steps[0].view == "spikes");
    alt(key::kPageDown);
    CHECK(program.lesson().lesson->steps[1].view == "spikes");
}

}  // namespace lesson_writing_test
