// Popups open beside their button, and do not cover the item they change.

#include "tests/support/program.h"

namespace popups_test {

using namespace tact;

TEST_CASE("popups: rhythms of a wide editor open beside the fields that they change") {
    Program program(short_patterns(3));
    program.app.layout.maximised = Pane::editor;
    for (const ImVec2 size : {ImVec2{1280.0F, 720.0F}, ImVec2{2560.0F, 1440.0F}}) {
        program.resize(size, 1.0F);
        program.click("link:rhythms");
        REQUIRE(program.shows("rhythm list:Necklaces"));
        const Place& list = program.at("rhythm list:Necklaces");
        CHECK(list.max.x < program.at("rhythm").min.x);
        CHECK(program.at("rhythm").min.x - list.max.x < 0.35F * size.x);
        program.press_key(key::kEscape);
    }
}

namespace {

struct MapInDesign : Program {
    MapInDesign() : Program(short_patterns(3)) {
        compute_map();
        app.layout = first_layout(Arrangement::design);
        settle();
    }
};

}  // namespace

TEST_CASE("popups: the map's look covers neither the map nor the patterns") {
    MapInDesign program;
    program.click("link:map look");
    CHECK(program.at("look:Colour by").min.x > program.at("pane:Perceptual space").max.x);
}

TEST_CASE("popups: the numbers that may change cover neither the map nor what steers it") {
    MapInDesign program;
    program.press('v');
    program.settle();
    program.click("link:free numbers");
    CHECK(program.at("free:amplitude_g").min.x > program.at("pane:Perceptual space").max.x);
}

TEST_CASE("popups: the menu of a row leaves its name in sight, at whatever height it is") {
    Program program(short_patterns(12));
    program.resize({1280.0F, 720.0F}, 1.0F);
    for (const char* row : {"row:p1", "row:p6"}) {
        CAPTURE(row);
        program.window.move(program.at(row).middle());
        program.window.button(true, 1);
        program.window.button(false, 1);
        program.settle();
        REQUIRE(program.shows("row menu:Play"));
        const Place& named = program.at(row);
        const bool below = program.at("row menu:Play").min.y >= named.max.y;
        const bool above = program.at("row menu:Delete").max.y <= named.min.y;
        CHECK((below || above));
        CHECK(program.at("row menu:Delete").max.y <= 720.0F);
        program.press_key(key::kEscape);
    }
}

TEST_CASE("tabs: none hangs below the others by itself") {
    Program program(short_patterns(3));
    program.resize({1280.0F, 720.0F}, 1.0F);
    CHECK(program.at("tab:Model").min.y == program.at("tab:Device").min.y);
    CHECK(program.at("tab:Matrix").min.y == program.at("tab:Table").min.y);
}

TEST_CASE("editor: a locked pattern's links do nothing") {
    PatternSet set = short_patterns(2);
    set.vibrations[0].locked = true;
    Program program(set);
    const Pattern before = program.pattern(0);
    for (const char* name : {"link:add carrier", "link:make a rhythm", "link:rhythms"}) {
        if (program.shows(name)) program.click(name);
    }
    CHECK(program.pattern(0) == before);
    CHECK(!program.shows("rhythm list:count"));
}

}  // namespace popups_test
