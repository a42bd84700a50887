// A pattern pressed and held plays until it is released; a click and a drag keep their meaning.
#include <doctest/doctest.h>

#include "app/document/editing.h"
#include "app/generate/generate.h"
#include "tests/support/felt_program.h"
#include "tests/support/patience.h"

namespace holding_test {

using namespace tact;

namespace {

void press_on(FeltProgram& program, const std::string& widget) {
    program.window.move(program.at(widget).middle());
    program.window.button(true);
    program.settle();
}

void let_go(FeltProgram& program) {
    program.window.button(false);
    program.settle();
}

}  // namespace

TEST_CASE("holding: a row is felt over and over until it is let go, and is selected") {
    FeltProgram program;
    press_on(program, "row:p2");
    CHECK_FALSE(program.device->playing());  // it may be a click, or the start of a drag
    program.wait(kHoldS + 0.05);
    CHECK(program.plays(1));
    CHECK(program.device->looping());
    program.wait(1.0);
    CHECK(program.device->begun() == 1);
    let_go(program);
    CHECK_FALSE(program.device->playing());
    CHECK(program.app.work.selection.current == 1);
    program.wait(1.0);
    CHECK(program.device->begun() == 1);
}

TEST_CASE("holding: a click is short enough to stay silent, and selects") {
    FeltProgram program;
    press_on(program, "row:p3");
    let_go(program);
    program.wait(1.0);
    CHECK(program.device->begun() == 0);
    CHECK(program.app.work.selection.current == 2);
}

TEST_CASE("holding: a row that is dragged is moved and not felt, also where it was felt before") {
    FeltProgram program;
    const ImVec2 first = program.at("row:p1").middle();
    const ImVec2 third = program.at("row:p3").middle();
    program.drag(first, third, 4);
    program.wait(0.5);
    CHECK(program.device->begun() == 0);
    CHECK(program.app.work.document.set.vibrations[2].name == "p1");
    press_on(program, "row:p1");
    program.wait(kHoldS + 0.05);
    REQUIRE(program.device->playing());
    program.window.move(first);
    program.settle();
    CHECK_FALSE(program.device->playing());
    let_go(program);
    CHECK(program.app.work.document.set.vibrations[0].name == "p1");
}

TEST_CASE("holding: it takes the place of what sounded, and Esc ends it for good") {
    FeltProgram program;
    program.app.timeline.playhead.loop = true;
    program.space();
    REQUIRE(program.plays(0));
    press_on(program, "row:p2");
    CHECK(program.plays(0));
    program.wait(kHoldS + 0.05);
    CHECK(program.plays(1));
    program.press_key(key::kEscape);
    CHECK_FALSE(program.device->playing());
    program.wait(1.0);
    CHECK_FALSE(program.device->playing());
    let_go(program);
    CHECK_FALSE(is_sounding(program.app.play));
}

TEST_CASE("holding: without a device nothing sounds, and nothing is waited for") {
    Program program(short_patterns(2));
    program.window.move(program.at("row:p2").middle());
    program.window.button(true);
    for (int k = 0; k < 60; ++k) program.frame();
    CHECK_FALSE(is_sounding(program.app.play));
    CHECK_FALSE(program.app.timeline.playhead.playing);
    program.window.button(false);
    program.settle();
    CHECK(program.app.work.selection.current == 1);
}

TEST_CASE("holding: a point of the map is felt, and a click on it still selects") {
    FeltProgram program(5);
    program.compute_map();
    program.wait(0.5);  // until its points have come to rest
    press_on(program, "point:p4");
    CHECK_FALSE(program.device->playing());
    program.wait(kHoldS + 0.05);
    CHECK(program.plays(3));
    let_go(program);
    CHECK_FALSE(program.device->playing());
    CHECK(program.app.work.selection.current == 3);
}

TEST_CASE("holding: a candidate is felt before it is in the set") {
    FeltProgram program;
    program.press('g', true);
    const auto until = end_of_patience();
    while (!program.shows("generate:preview 2")) {
        REQUIRE(std::chrono::steady_clock::now() < until);
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
        program.frame();
    }
    program.settle();
    const auto plan = current_plan(program.app.work, program.app.generating);
    REQUIRE(plan);
    press_on(program, "generate:preview 2");
    program.wait(kHoldS + 0.05);
    REQUIRE(program.device->playing());
    Vibration candidate;
    candidate.source = plan->add.fresh[2].pattern;
    const Drive whole = drive_of(waveform_of(candidate), 1.0);
    CHECK(*program.device->playing() == protected_drive(whole, true, true).drive);
    let_go(program);
    CHECK_FALSE(program.device->playing());
    CHECK(program.app.ui.dialog == kGenerateDialog);
    CHECK(program.app.work.document.set.vibrations.size() == 3);
}

}  // namespace holding_test
