// Actions on a row of a list while the list is drawn; with the library's checks on, an index past
// the end aborts.

#include "app/subset/subset.h"
#include "app/window/window.h"
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
        choose(program, last, "Exclude");
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

TEST_CASE("rows: while a row is dragged a line shows where it would come") {
    Program program(short_patterns(4));
    CHECK_FALSE(program.shows("drop line"));
    const auto line_over = [&](const char* from, const char* to) {
        program.window.move(program.at(from).middle());
        program.window.button(true);
        program.settle();
        program.window.move(program.at(to).middle());
        program.settle();
        const float y = program.at("drop line").middle().y;
        program.window.move(program.at(from).middle());  // back: nothing moves
        program.window.button(false);
        program.settle();
        return y;
    };
    CHECK(line_over("row:p4", "row:p2") == doctest::Approx(program.at("row:p2").min.y));
    CHECK(line_over("row:p1", "row:p3") == doctest::Approx(program.at("row:p3").max.y));
    CHECK(program.app.work.document.set == short_patterns(4));
}

TEST_CASE("rows: the picture of a waveform is always there, however long the name") {
    PatternSet set = short_patterns(3);
    set.vibrations[1].name = "0.4 g 60 Hz, four notes on eight steps, softly begun";
    for (const float width : {1100.0F, 1600.0F, 2560.0F}) {
        Program program(set);
        program.resize({width, 1000.0F}, 1.0F);
        for (const Vibration& vibration : set.vibrations) {
            CAPTURE(vibration.name);
            const Place picture = program.at("thumbnail:" + vibration.name);
            const Place row = program.at("row:" + vibration.name);
            CHECK(picture.max.x - picture.min.x >= 36.0F);
            CHECK(picture.min.x >= program.at("row name:" + vibration.name).max.x);
            CHECK(picture.max.x <= row.max.x);
            CHECK(picture.min.y >= row.min.y);
            CHECK(picture.max.y <= row.max.y);
        }
    }
}

TEST_CASE("rows: few rows are higher than many, and pictures grow with the pane") {
    Program few(short_patterns(3));
    const auto height = [](const Program& program) {
        return program.at("row:p1").max.y - program.at("row:p1").min.y;
    };
    const auto width = [](const Program& program) {
        return program.at("thumbnail:p1").max.x - program.at("thumbnail:p1").min.x;
    };
    const float of_few = height(few);
    const float narrow = width(few);
    few.resize({2560.0F, 1440.0F}, 1.0F);
    CHECK(width(few) > 1.3F * narrow);
    const Program many(short_patterns(120));
    CHECK(of_few > height(many));
    CHECK(height(many) == 25.0F);
}

TEST_CASE("rows: the switch of the scale says how many g it is, and turns to each one's own") {
    PatternSet set = short_patterns(2);
    std::get<Pattern>(set.vibrations[1].source).amplitude_g = 4.0;
    Program program(set);
    CHECK(program.at("button:heights").value == "\u00b14 g");
    program.click("button:heights");
    CHECK(program.app.work.own_heights);
    CHECK(program.at("button:heights").value == "own heights");
}

TEST_CASE("rows: a pattern that no receptor answers to is marked, until it is edited") {
    PatternSet set = short_patterns(3);
    std::get<Pattern>(set.vibrations[1].source).amplitude_g = 0.0;
    Program program(set);
    CHECK_FALSE(program.shows("not felt:p2"));  // not known yet
    program.compute_map();
    program.settle();
    CHECK(program.shows("not felt:p2"));
    CHECK_FALSE(program.shows("not felt:p1"));
    CHECK_FALSE(program.shows("editor:not felt"));
    program.click("row:p2");
    CHECK(program.shows("editor:not felt"));
    program.app.ui.wake = {};  // no map of the edit is asked for
    edit_patterns(program.app.work, [](Pattern& p) { p.amplitude_g = 3.0; });
    program.settle();
    CHECK_FALSE(program.shows("not felt:p2"));
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

TEST_CASE("rows: where a search finds none, one press shows all again") {
    Program program(short_patterns(3));
    program.app.work.selection.search = "no such name";
    program.app.work.selection.picked = {"p2"};
    program.app.work.selection.only_picked = true;
    program.settle();
    CHECK_FALSE(program.shows("row:p2"));
    program.click("button:show all");
    for (const char* name : {"row:p1", "row:p2", "row:p3"}) CHECK(program.shows(name));
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
