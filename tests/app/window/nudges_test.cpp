// Numbers of the window, stepped and nudged with arrows.
#include <functional>

#include "tests/support/typed_numbers.h"

namespace nudges_test {

using namespace tact;

namespace {

void hold(Program& program, int code, const std::function<void()>& then) {
    push(program.window.input, {program.window.now_s, KeyChange{code, true, false, 0}});
    program.settle();
    then();
    push(program.window.input, {program.window.now_s, KeyChange{code, false, false, 0}});
    program.settle();
}

}  // namespace

TEST_CASE("numbers: Up and Down step at once, Shift coarsely, and Esc takes all of it back") {
    Program program(odd_numbers(1));
    program.click("entry:amplitude_g");
    program.press_key(key::kUp);
    CHECK(program.pattern(0).amplitude_g == doctest::Approx(1.55).epsilon(1e-12));
    program.press_key(key::kDown);
    program.press_key(key::kDown);
    CHECK(program.pattern(0).amplitude_g == doctest::Approx(1.45).epsilon(1e-12));
    hold(program, key::kLeftShift, [&] { program.press_key(key::kUp); });
    CHECK(program.pattern(0).amplitude_g == doctest::Approx(1.70).epsilon(1e-12));
    hold(program, key::kLeftAlt, [&] { program.press_key(key::kUp); });
    CHECK(program.pattern(0).amplitude_g == doctest::Approx(1.705).epsilon(1e-12));
    program.press_key(key::kEscape);
    CHECK(program.pattern(0).amplitude_g == 1.5);
    program.press('z', true);
    CHECK(program.pattern(0).amplitude_g == 1.5);
    CHECK(program.app.work.selection.current == 0);
}

TEST_CASE("numbers: a nudge goes on from a typed value, beyond the slider too") {
    Program program(odd_numbers(1));
    enter(program, "entry:amplitude_g", "10");
    program.press_key(key::kRight);
    CHECK(program.pattern(0).amplitude_g == doctest::Approx(10.05).epsilon(1e-12));
    enter(program, "entry:carrier_1_hz", "700");
    program.press_key(key::kLeft);
    CHECK(program.pattern(0).carriers[0].frequency_hz == 699.0);
    // Off the grid it goes to the next multiple, at most one step away.
    enter(program, "entry:modulation_hz", "2.25");
    program.press_key(key::kRight);
    CHECK(program.pattern(0).modulation.frequency_hz == 3.0);
    enter(program, "entry:modulation_hz", "2.25");
    program.press_key(key::kLeft);
    CHECK(program.pattern(0).modulation.frequency_hz == 2.0);
    enter(program, "entry:amplitude_g", "50");
    program.press_key(key::kRight);
    CHECK(program.pattern(0).amplitude_g == 50.0);
}

TEST_CASE("numbers: nudges in quick succession are one undo step, after a pause another") {
    Program program(odd_numbers(1));
    program.click("slider:amplitude_g");
    const double start_g = program.pattern(0).amplitude_g;
    program.window.now_s += 5.0;
    for (int k = 0; k < 6; ++k) program.press_key(key::kRight);
    const double first_g = program.pattern(0).amplitude_g;
    program.window.now_s += 5.0;
    for (int k = 0; k < 3; ++k) program.press_key(key::kRight);
    program.press('z', true);
    CHECK(program.pattern(0).amplitude_g == first_g);
    program.press('z', true);
    CHECK(program.pattern(0).amplitude_g == start_g);
    program.press('z', true, true);
    CHECK(program.pattern(0).amplitude_g == first_g);
}

TEST_CASE("numbers: the wheel steps the focused field, one step a turn, and scrolls nothing") {
    PatternSet set = odd_numbers(2);
    Program program(set);
    program.resize({1600.0F, 760.0F}, 1.0F);  // the editor is taller than its pane
    const auto turn = [&](float by) {
        push(program.window.input, {program.window.now_s, MouseWheel{0.0F, by}});
        program.settle();
    };
    const auto top = [&] { return program.at("entry:amplitude_g").min.y; };
    const float before = top();
    program.hover(program.at("slider:modulation_hz").middle());
    turn(-1.0F);
    CHECK(top() < before);  // not the focused one: the pane scrolls
    turn(1.0F);
    REQUIRE(top() == before);
    program.click("slider:amplitude_g");
    const double start_g = program.pattern(0).amplitude_g;
    turn(1.0F);
    turn(1.0F);
    CHECK(program.pattern(0).amplitude_g == doctest::Approx(start_g + 0.1).epsilon(1e-9));
    hold(program, key::kLeftShift, [&] { turn(-1.0F); });
    CHECK(program.pattern(0).amplitude_g == doctest::Approx(start_g - 0.15).epsilon(1e-9));
    turn(0.5F);  // half a turn of a touch pad
    CHECK(program.pattern(0).amplitude_g == doctest::Approx(start_g - 0.15).epsilon(1e-9));
    turn(0.5F);
    CHECK(program.pattern(0).amplitude_g == doctest::Approx(start_g - 0.1).epsilon(1e-9));
    CHECK(top() == before);
    program.press('z', true);
    CHECK(program.pattern(0).amplitude_g == start_g);  // in quick succession: one step
}

TEST_CASE("numbers: the wheel steps a number that is being typed, from what is typed") {
    Program program(odd_numbers(1));
    program.click("entry:amplitude_g");
    program.type("2");
    push(program.window.input, {program.window.now_s, MouseWheel{0.0F, 1.0F}});
    program.settle();
    CHECK(program.pattern(0).amplitude_g == doctest::Approx(2.05).epsilon(1e-12));
    program.press_key(key::kEscape);
    CHECK(program.pattern(0).amplitude_g == 1.5);
}

TEST_CASE("numbers: nudges of one pattern and then of another are two steps, however quick") {
    Program program(odd_numbers(2));
    program.click("entry:amplitude_g");
    program.press_key(key::kEnter);
    program.press_key(key::kRight);
    program.click("row:p2");
    program.click("entry:amplitude_g");
    program.press_key(key::kEnter);
    program.press_key(key::kRight);
    program.press('z', true);
    CHECK(program.pattern(1).amplitude_g == 1.5);
    CHECK(program.pattern(0).amplitude_g > 1.5);
}

TEST_CASE("numbers: the field that arrows nudge is marked, and forgotten with its pattern") {
    Program program(odd_numbers(2));
    CHECK_FALSE(program.shows("nudged by arrows"));
    program.click("slider:modulation_hz");
    REQUIRE(program.shows("nudged by arrows"));
    CHECK(program.at("nudged by arrows").value == "modulation_hz");
    program.click("row:p2");
    CHECK_FALSE(program.shows("nudged by arrows"));
    program.press_key(key::kRight);
    CHECK(program.pattern(1).modulation.frequency_hz == 2.5);
}

}  // namespace nudges_test
