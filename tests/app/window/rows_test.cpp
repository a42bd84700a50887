// What is done in a row of a list while the list is drawn; run with the checks of the library on,
// an index past the end aborts.

#include "app/subset/separation_follow.h"
#include "app/window/frame.h"
#include "tests/support/program.h"

namespace rows_test {

using namespace tact;

namespace {

void click_right(Program& program, const std::string& name) {
    program.window.move(program.at(name).middle());
    program.window.button(true, 1);
    program.window.button(false, 1);
    program.settle();
}

void choose(Program& program, const std::string& row, const std::string& action) {
    click_right(program, "row:" + row);
    program.click("row menu:" + action);
}

std::size_t size_of(const Program& program) {
    return program.app.work.document.set.vibrations.size();
}

const Vibration& last_of(const Program& program) {
    return program.app.work.document.set.vibrations.back();
}

void click_with(Program& program, int modifier, const std::string& name) {
    push(program.window.input, {program.window.now_s, KeyChange{modifier, true, false, 0}});
    program.settle();
    program.click(name);
    push(program.window.input, {program.window.now_s, KeyChange{modifier, false, false, 0}});
    program.settle();
}

}  // namespace

TEST_CASE("rows: every action in the menu of the last row does what it says, to it alone") {
    for (const std::size_t count : {1U, 3U}) {
        CAPTURE(count);
        const std::string last = "p" + std::to_string(count);
        Program program(short_patterns(count));
        choose(program, last, "Delete");
        CHECK(size_of(program) == count - 1);
        CHECK_FALSE(program.shows("row:" + last));
        program.press('z', true);
        CHECK(program.app.work.document.set == short_patterns(count));
        choose(program, last, "Duplicate");
        CHECK(size_of(program) == count + 1);
        program.press('z', true);
        choose(program, last, "Lock");
        CHECK(last_of(program).locked);
        choose(program, last, "Unlock");
        CHECK_FALSE(last_of(program).locked);
        choose(program, last, "Drop");
        CHECK(last_of(program).dropped);
        choose(program, last, "Copy");
        CHECK(program.app.work.clipboard.size() == 1);
        choose(program, last, "Rename");
        CHECK(program.shows("rename"));
        program.type("other");
        program.press_key(key::kEnter);
        CHECK(last_of(program).name == "other");
    }
}

TEST_CASE("rows: deleting several by the menu of the last leaves the others whole") {
    Program program(short_patterns(5));
    program.click("row:p3");
    click_with(program, key::kLeftShift, "row:p5");
    choose(program, "p5", "Delete");
    CHECK(size_of(program) == 2);
    CHECK(program.shows("row:p2"));
}

TEST_CASE("rows: the last row dragged to the top is the first one") {
    Program program(short_patterns(4));
    program.drag(program.at("row:p4").middle(), program.at("row:p1").middle(), 4);
    CHECK(program.app.work.document.set.vibrations[0].name == "p4");
    CHECK(size_of(program) == 4);
}

TEST_CASE("rows: the box of a name lets go when something else is clicked, and keeps the name") {
    Program program(short_patterns(3));
    program.press_key(key::kF1 + 1);
    REQUIRE(program.shows("rename"));
    program.type("first");
    program.click("search");
    CHECK_FALSE(program.shows("rename"));
    CHECK(program.app.work.document.set.vibrations[0].name == "first");
    program.type("p3");
    CHECK(program.app.work.selection.search == "p3");
    CHECK(program.app.work.document.set.vibrations[0].name == "first");
    program.app.work.selection.search.clear();
    program.settle();
    program.press_key(key::kEscape);
    program.click("row:p2");
    program.press_key(key::kF1 + 1);
    program.type("second");
    program.click("row:p3");
    CHECK(program.app.work.document.set.vibrations[1].name == "second");
    program.press_key(key::kF1 + 1);
    program.type("never");
    program.press_key(key::kEscape);
    CHECK_FALSE(program.shows("rename"));
    CHECK(last_of(program).name == "p3");
}

TEST_CASE("rows: nothing that a search hides is selected or changed with what it shows") {
    PatternSet set = short_patterns(5);
    for (const std::size_t k : {0U, 2U, 4U}) set.vibrations[k].name = "tap " + std::to_string(k);
    const auto amplitudes = [](const Program& program) {
        std::vector<double> all;
        for (std::size_t k = 0; k < 5; ++k) all.push_back(program.pattern(k).amplitude_g);
        return all;
    };
    const auto double_it = [](Pattern& p) { p.amplitude_g = 2.0; };
    const std::vector<double> seen{2.0, 1.0, 2.0, 1.0, 2.0};
    {
        Program program(set);
        program.app.work.selection.search = "tap";
        program.settle();
        program.click("row:tap 0");
        click_with(program, key::kLeftShift, "row:tap 4");
        edit_patterns(program.app.work, double_it);
        CHECK(amplitudes(program) == seen);
        CHECK(of_selection(program.app.work, "amplitude") == "amplitude of 3 patterns");
    }
    {
        Program program(set);
        program.click("row:p2");
        program.app.work.selection.search = "tap";
        program.settle();
        program.press('a', true);
        edit_patterns(program.app.work, double_it);
        CHECK(amplitudes(program) == seen);
    }
    {
        // Selected before the search was typed.
        Program program(set);
        program.press('a', true);
        program.app.work.selection.search = "tap";
        program.settle();
        edit_patterns(program.app.work, double_it);
        toggle_locked(program.app.ui, program.app.work);
        CHECK(amplitudes(program) == seen);
        CHECK_FALSE(program.app.work.document.set.vibrations[1].locked);
        CHECK(program.app.work.document.set.vibrations[2].locked);
    }
}

TEST_CASE("rows: a change that separates two makes a generated pattern one's own") {
    PatternSet set = short_patterns(3);
    for (Vibration& vibration : set.vibrations) vibration.generated = true;
    Program program(set);
    Separation separation;
    separation.parameter = PatternParameter::amplitude;
    separation.to = 3.0;
    apply_separation(program.app.ui, program.app.work, 1, separation);
    CHECK_FALSE(program.app.work.document.set.vibrations[1].generated);
    CHECK(program.app.work.document.set.vibrations[2].generated);
    CHECK(program.pattern(1).amplitude_g == 3.0);
}

}  // namespace rows_test
