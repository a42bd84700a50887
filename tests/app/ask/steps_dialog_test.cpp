// Steps between two patterns, in the window.
#include "app/ask/ask.h"
#include "tests/support/patience.h"
#include "tests/support/program.h"

namespace steps_dialog_test {

using namespace tact;

namespace {

std::shared_ptr<const FoundSteps> wait_for_steps(Program& program) {
    const auto until = end_of_patience();
    program.settle();
    while (!current_steps(program.app.work, program.app.steps)) {
        REQUIRE(std::chrono::steady_clock::now() < until);
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
        program.frame();
    }
    program.settle();
    return current_steps(program.app.work, program.app.steps);
}

void hold_ctrl(Program& program, bool down) {
    push(program.window.input,
         {program.window.now_s, KeyChange{key::kLeftControl, down, false, 0}});
    program.settle();
}

}  // namespace

TEST_CASE("steps dialog: what it finds comes between the two, as one step of undo") {
    Program program(short_patterns(3));
    const PatternSet before = program.app.work.document.set;
    open_steps(program.app.ui, program.app.work, program.app.steps, "p1", "p3");
    const auto found = wait_for_steps(program);
    CHECK(found->steps.patterns.size() == 5);
    CHECK(program.at("steps:From").value == "p1");
    CHECK(program.at("steps:To").value == "p3");
    CHECK(program.at("steps:verdict").value == sentence_on(found->request.question, found->steps));
    CHECK(program.app.work.document.set == before);
    program.click("button:choose");
    const auto& all = program.app.work.document.set.vibrations;
    REQUIRE(all.size() == 6);
    CHECK(all[1].name == "p1 to p3 2");
    CHECK(std::get<Pattern>(all[1].source) == found->steps.patterns[1]);
    CHECK(all[4].name == "p2");
    undo(program.app.ui, program.app.work);
    CHECK(program.app.work.document.set == before);
}

TEST_CASE("steps dialog: another question is asked at once; Esc leaves the set as it is") {
    Program program(short_patterns(3));
    const PatternSet before = program.app.work.document.set;
    open_steps(program.app.ui, program.app.work, program.app.steps, "p1", "p2");
    wait_for_steps(program);
    program.app.steps.count = 3;
    CHECK_FALSE(current_steps(program.app.work, program.app.steps));
    CHECK(wait_for_steps(program)->steps.patterns.size() == 3);
    program.app.steps.to = "p1";
    program.settle();
    CHECK(program.shows("steps:obstacle"));
    program.press_key(key::kEscape);
    CHECK(program.app.ui.dialog == kNoDialog);
    CHECK(program.app.work.document.set == before);
    CHECK(program.app.work.document.history.undo_label() == nullptr);
}

TEST_CASE("steps dialog: Ctrl+drag from a point of the map to another opens it on the two") {
    Program program(short_patterns(4));
    program.compute_map();
    program.app.ui.motion = false;
    program.settle();
    const ImVec2 from = program.at("point:p2").middle();
    const ImVec2 to = program.at("point:p4").middle();
    hold_ctrl(program, true);
    program.drag(from, to, 6);
    hold_ctrl(program, false);
    CHECK(program.app.ui.dialog == kStepsDialog);
    CHECK(program.app.steps.from == "p2");
    CHECK(program.app.steps.to == "p4");
}

TEST_CASE("map: Ctrl+click adds to the selection, Shift+drag selects all within the box") {
    Program program(short_patterns(4));
    program.compute_map();
    program.app.ui.motion = false;
    program.settle();
    program.click("point:p1");
    hold_ctrl(program, true);
    program.click("point:p3");
    hold_ctrl(program, false);
    CHECK(program.app.work.selection.current == 0);
    CHECK(program.app.work.selection.others == std::set<std::size_t>{2});
    Rect all{program.at("point:p1").min, program.at("point:p1").min};
    for (const char* name : {"point:p2", "point:p3", "point:p4"}) {
        all = around(all, {program.at(name).min, program.at(name).min});
    }
    push(program.window.input, {program.window.now_s, KeyChange{key::kLeftShift, true, false, 0}});
    program.drag(all.min - ImVec2{12, 12}, all.max + ImVec2{12, 12}, 6);
    push(program.window.input, {program.window.now_s, KeyChange{key::kLeftShift, false, false, 0}});
    program.settle();
    CHECK(selected_indices(program.app.work).size() == 4);
}

}  // namespace steps_dialog_test
