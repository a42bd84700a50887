#include "app/window/window.h"

#include <cmath>

#include "tests/support/program.h"

namespace gestures_test {

using namespace tact;

namespace {

// Presses on the slider and moves, without releasing it.
void hold_slider(Program& program, const std::string& name) {
    const Place bar = program.at(name);
    const float y = bar.middle().y;
    program.window.move({bar.min.x + 10.0F, y});
    program.window.button(true);
    program.settle();
    program.window.move({bar.min.x + 40.0F, y});
    program.settle();
}

}  // namespace

TEST_CASE("gestures: a slider held while Down is pressed stays with the pattern it began on") {
    Program program(short_patterns(3));
    hold_slider(program, "slider:amplitude_g");
    const double held_g = program.pattern(0).amplitude_g;
    CHECK(held_g != 1.0);
    program.press_key(key::kDown);
    CHECK(program.app.work.selection.current == 1);
    program.window.move(program.at("slider:amplitude_g").max);
    program.settle();
    program.window.button(false);
    program.settle();
    CHECK(program.pattern(0).amplitude_g == held_g);
    CHECK(program.pattern(1).amplitude_g == 1.0);
    REQUIRE(program.app.work.document.history.undo_label() != nullptr);
    CHECK(*program.app.work.document.history.undo_label() == "Change amplitude of p1");
    program.press('z', true);
    CHECK(program.app.work.document.set == short_patterns(3));
}

TEST_CASE("gestures: a slider held while Delete is pressed is a step of its own") {
    Program program(short_patterns(3));
    hold_slider(program, "slider:amplitude_g");
    const double held_g = program.pattern(0).amplitude_g;
    program.press_key(key::kDelete);
    program.window.move(program.at("slider:amplitude_g").max);
    program.settle();
    program.window.button(false);
    program.settle();
    REQUIRE(program.app.work.document.set.vibrations.size() == 2);
    CHECK(program.pattern(0).amplitude_g == 1.0);
    program.press('z', true);
    CHECK(program.pattern(0).amplitude_g == held_g);
    program.press('z', true);
    CHECK(program.app.work.document.set == short_patterns(3));
}

TEST_CASE("gestures: Ctrl+D in the middle of a number finishes it first, on the original") {
    Program program(short_patterns(2));
    program.click("entry:amplitude_g");
    program.window.type("2.5");
    program.settle();
    program.press('d', true);
    REQUIRE(program.app.work.document.set.vibrations.size() == 3);
    CHECK(program.pattern(0).amplitude_g == 2.5);
    CHECK(program.pattern(1).amplitude_g == 2.5);  // the test's copy
    program.press('z', true);
    CHECK(program.app.work.document.set.vibrations.size() == 2);
    CHECK(program.pattern(0).amplitude_g == 2.5);
    program.press('z', true);
    CHECK(program.app.work.document.set == short_patterns(2));
}

TEST_CASE("gestures: a rhythm left by a click on another row is a step of its own pattern") {
    Program program(short_patterns(3));
    program.click("rhythm");
    program.window.type("x--");
    program.settle();
    program.click("row:p3");
    CHECK(program.app.work.selection.current == 2);
    REQUIRE(program.app.work.document.history.undo_label() != nullptr);
    CHECK(*program.app.work.document.history.undo_label() == "Change rhythm of p1");
    CHECK(program.pattern(0).rhythm.text == "x--");
    CHECK(program.pattern(2).rhythm.text.empty());
}

TEST_CASE("gestures: Delete leaves what the search hides, and says so") {
    Program program(short_patterns(3));
    program.app.work.selection.search = "p2";
    program.press_key(key::kDelete);
    CHECK(program.app.work.document.set == short_patterns(3));
    CHECK(program.app.ui.status.text.find("search") != std::string::npos);
    program.press('a', true);
    program.press_key(key::kDelete);
    CHECK(program.app.work.document.set.vibrations.size() == 2);
    CHECK_FALSE(program.shows("row:p2"));
    program.app.work.selection.search.clear();
    program.press_key(key::kDelete);
    CHECK(program.app.work.document.set.vibrations.size() == 1);
}

TEST_CASE("gestures: Down goes to the next pattern in the list, over what the search hides") {
    PatternSet set = short_patterns(4);
    set.vibrations[1].name = "tap";
    set.vibrations[3].name = "tip";
    Program program(set);
    program.app.work.selection.search = "t";
    program.press_key(key::kDown);
    CHECK(program.app.work.selection.current == 1);
    program.press_key(key::kDown);
    CHECK(program.app.work.selection.current == 3);
    program.press_key(key::kUp);
    CHECK(program.app.work.selection.current == 1);
}

TEST_CASE("gestures: Esc closes an open menu") {
    Program program(short_patterns(2));
    program.click("menu:Edit");
    REQUIRE(program.shows("menu:Duplicate"));
    program.press_key(key::kEscape);
    CHECK_FALSE(program.shows("menu:Duplicate"));
    program.press_key(key::kDown);
    CHECK(program.app.work.selection.current == 1);
}

TEST_CASE(
    "gestures: a line at the foot waits for somebody to read it, then for the frame it fades in") {
    Program program(short_patterns(2));
    const auto wake_after_s = [&program] {
        program.app.work.autosave_pending = false;  // requests frames
        return next_wake_s(program.app);
    };
    CHECK(std::isinf(wake_after_s()));
    say(program.app.ui, "Done.");
    CHECK(std::isinf(wake_after_s()));
    program.window.now_s += 100.0;
    program.settle();
    CHECK(program.shows("status"));
    for (const float x : {300.0F, 301.0F}) {
        program.window.move({x, 300.0F});
        program.settle();
    }
    const double wake_s = wake_after_s();
    CHECK(wake_s > 1.0);
    CHECK(program.shows("status"));
    program.window.now_s += wake_s;
    program.settle();
    CHECK_FALSE(program.shows("status"));
    CHECK(std::isinf(wake_after_s()));
    complain(program.app.ui, "Not done.");
    CHECK(std::isinf(wake_after_s()));
}

TEST_CASE("gestures: the palette tells the shortcuts of what it finds") {
    Program program(short_patterns(2));
    program.press('p', true);
    program.window.type("dupl");
    program.settle();
    CHECK(program.at("palette:Duplicate").value == "Ctrl+D");
    program.click("palette:Duplicate");
    CHECK(program.app.work.document.set.vibrations.size() == 3);
}

TEST_CASE("gestures: calibrating is found in the palette and in the Play menu") {
    Program program(short_patterns(2));
    program.press('p', true);
    program.window.type("calib");
    program.settle();
    CHECK(program.shows("palette:Calibrate..."));
    program.press_key(key::kEscape);
    program.click("menu:Play");
    CHECK(program.shows("menu:Calibrate..."));
    program.click("menu:Calibrate...");
    // An actuator is measured through a sound output, which the program asks for if none is chosen.
    CHECK((program.app.ui.dialog == kCalibrateDialog || program.app.ui.dialog == kDevicesDialog));
}

TEST_CASE("gestures: the palette says why a command cannot be done, below those that can") {
    Program program(short_patterns(2));
    program.press('p', true);
    program.window.type("undo");
    program.settle();
    CHECK(program.at("palette:Undo").value == "nothing to undo");
    program.press_key(key::kEnter);
    CHECK(program.app.palette.open);  // nothing was undone
    program.press_key(key::kEscape);
    program.press('p', true);
    program.window.type("re");  // redo, rename, report ...
    program.settle();
    CHECK(program.shows("palette:Rename"));
    CHECK_FALSE(program.shows("palette:Redo"));  // twelve enabled commands come first
    program.window.type("do");
    program.settle();
    CHECK(program.at("palette:Redo").value == "nothing to redo");
}

TEST_CASE("gestures: an empty set's editor says where a pattern comes from") {
    Program program(short_patterns(0));
    CHECK(program.shows("button:new"));
    program.click("button:new");
    CHECK(program.shows("entry:amplitude_g"));
}

}  // namespace gestures_test
