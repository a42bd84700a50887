// The keyboard reaches everything that the mouse can press.

#include "app/ui/ui.h"

#include <algorithm>

#include "tests/support/program.h"

namespace tab_order_test {

using namespace tact;

namespace {

// The item with the focus: the first noted one with its rectangle.
std::string focused(const Program& program) {
    const auto& focus = program.at("focus");
    for (const auto& [name, place] : program.places) {
        const bool same = place.min.x == focus.min.x && place.min.y == focus.min.y &&
                          place.max.x == focus.max.x && place.max.y == focus.max.y;
        if (same && name != "focus") return name;
    }
    return {};
}

std::string focused_or_none(const Program& program) {
    return program.shows("focus") ? focused(program) : std::string();
}

// Names of the stops, once around.
std::vector<std::string> round_trip(Program& program, bool back) {
    std::vector<std::string> names;
    for (int k = 0; k < 400; ++k) {
        program.press_key(key::kTab, false, back);
        const std::string name = focused(program);
        if (!names.empty() && name == names.front()) return names;
        names.push_back(name);
    }
    return names;
}

}  // namespace

TEST_CASE("tab: from the first control it goes through every pane, comes around, and back") {
    Program program(short_patterns(3));
    const std::vector<std::string> there = round_trip(program, false);
    REQUIRE_FALSE(there.empty());
    CHECK(there.front() == "transport:play");
    // Items of every kind, in every pane.
    for (const char* name :
         {"speed:1/10", "button:new", "search", "row:p1", "hint:editor", "entry:amplitude_g",
          "link:add carrier", "radio:Tremolo", "entry:duration_s", "stage:spectrum", "radio:2-D",
          "link:map look", "tab:Why", "radio:NC"}) {
        CHECK_MESSAGE(std::ranges::count(there, name) == 1, name);
    }
    std::vector<std::string> back = round_trip(program, true);
    REQUIRE(back.size() == there.size());
    std::ranges::rotate(back, back.end() - 1);
    std::ranges::reverse(back);
    // From the first one, back is the last one.
    CHECK(std::ranges::is_permutation(back, there));
    const auto place = [](const std::vector<std::string>& all, const char* name) {
        return std::ranges::find(all, name) - all.begin();
    };
    CHECK(place(back, "button:new") < place(back, "row:p1"));
    CHECK(place(back, "row:p1") < place(back, "entry:amplitude_g"));
}

TEST_CASE("tab: nothing moves the numbers, the selection or the document on the way") {
    Program program(short_patterns(3));
    const PatternSet before = program.app.work.document.set;
    round_trip(program, false);
    CHECK(program.app.work.document.set == before);
    CHECK(program.app.work.selection.current == 0);
    CHECK(program.app.work.document.history.undo_label() == nullptr);
}

TEST_CASE("tab: Enter presses what has the focus, and the frame around it is seen") {
    Program program(short_patterns(3));
    while (focused_or_none(program) != "radio:2-D") program.press_key(key::kTab);
    REQUIRE(program.app.shown_map.dimensions == 3);
    program.press_key(key::kEnter);
    CHECK(program.app.shown_map.dimensions == 2);
    CHECK(focused(program) == "radio:2-D");
    program.click("row:p2");
    CHECK_FALSE(program.shows("focus"));  // the mouse needs none
}

TEST_CASE("tab: once it has left a number, one ring is on the screen, around what has the focus") {
    Program program(short_patterns(3));
    program.click("entry:amplitude_g");
    CHECK(program.shows("nudged by arrows"));
    program.press_key(key::kTab, false, true);
    program.press_key(key::kTab, false, true);
    CHECK(program.shows("focus"));
    CHECK_FALSE(program.shows("nudged by arrows"));
}

TEST_CASE("tab: Space presses what has the focus in a dialog, and plays in the panes") {
    Program program(short_patterns(3));
    while (focused_or_none(program) != "radio:2-D") program.press_key(key::kTab);
    program.press(U' ');
    CHECK(program.app.shown_map.dimensions == 3);
    CHECK(program.app.timeline.playhead.playing);
    program.press(U' ');
    program.press('g', true);  // generate
    while (focused_or_none(program) != "generate:amplitude range") program.press_key(key::kTab);
    CHECK(program.at("generate:amplitude range").value.empty());
    program.press(U' ');
    CHECK(program.at("generate:amplitude range").value == "chosen");
    CHECK_FALSE(program.app.timeline.playhead.playing);
    while (focused_or_none(program) != "generate:add carrier") program.press_key(key::kTab);
    const std::size_t carriers = program.app.generating.draft.carriers.size();
    program.press(U' ');
    CHECK(program.app.generating.draft.carriers.size() == carriers + 1);
    // In a text field it is a letter.
    while (focused_or_none(program) != "generate:rhythm") program.press_key(key::kTab);
    program.press(U' ');
    CHECK(program.app.ui.dialog == kGenerateDialog);
}

TEST_CASE("tab: with Ctrl it goes from pane to pane") {
    Program program(short_patterns(3));
    std::vector<std::string> firsts;
    for (int k = 0; k < 6; ++k) {
        program.press_key(key::kTab, true);
        firsts.push_back(focused(program));
    }
    const std::vector<std::string> expected{"transport:play",  "button:new", "hint:editor",
                                            "hint:physiology", "radio:3-D",  "tab:Matrix"};
    CHECK(firsts == expected);
    program.press_key(key::kTab, true, true);
    CHECK(focused(program) == "radio:3-D");
}

TEST_CASE("tab: within a dialog it stays there, and Enter on Cancel cancels") {
    Program program(short_patterns(3));
    program.press('g', true);  // generate
    REQUIRE(program.shows("button:cancel"));
    const auto size = program.app.work.document.set.vibrations.size();
    program.press_key(key::kTab);
    CHECK(focused(program) == "generate:amplitude values");  // its first control
    bool passed_number = false;
    do {
        program.press_key(key::kTab);
        passed_number |= focused(program).starts_with("generate:");
        REQUIRE_FALSE(focused(program).starts_with("row:"));
    } while (focused(program) != "button:cancel");
    CHECK(passed_number);
    program.press_key(key::kEnter);
    CHECK_FALSE(program.shows("button:cancel"));
    CHECK(program.app.work.document.set.vibrations.size() == size);
}

}  // namespace tab_order_test
