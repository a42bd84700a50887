#include <array>

#include "app/window/app.h"
#include "tests/support/program.h"

namespace legible_test {

using namespace tact;

namespace {

PatternSet long_names() {
    PatternSet set = short_patterns(5);
    set.name = "A set whose own name is rather longer than it would have to be";
    set.vibrations[0].name = "an alarm that comes in waves and does not stop";
    set.vibrations[2].name = "a slow heartbeat under a rising tone, second take";
    auto& pattern = std::get<Pattern>(set.vibrations[0].source);
    pattern.rhythm.text = "x=--x=x-";
    pattern.carriers.push_back({133.7, 0.5});
    return set;
}

struct Named {
    std::string name;
    Place place;
};

std::vector<Named> named(const Program& program, std::initializer_list<const char*> beginnings) {
    std::vector<Named> found;
    for (const auto& [name, place] : program.places) {
        for (const char* beginning : beginnings) {
            if (name.starts_with(beginning)) found.push_back({name, place});
        }
    }
    return found;
}

// Places are noted in whole pixels.
bool overlap(const Place& a, const Place& b) {
    return a.min.x + 1.0F < b.max.x && b.min.x + 1.0F < a.max.x && a.min.y + 1.0F < b.max.y &&
           b.min.y + 1.0F < a.max.y;
}

void check_apart(const std::vector<Named>& things) {
    for (std::size_t i = 0; i < things.size(); ++i) {
        for (std::size_t j = i + 1; j < things.size(); ++j) {
            CAPTURE(things[i].name);
            CAPTURE(things[j].name);
            CHECK_FALSE(overlap(things[i].place, things[j].place));
        }
    }
}

// From left to right; from top to bottom a pane may scroll.
void check_inside(const std::vector<Named>& things, const Place& pane) {
    for (const Named& thing : things) {
        CAPTURE(thing.name);
        CHECK(thing.place.min.x >= pane.min.x);
        CHECK(thing.place.max.x <= pane.max.x);
    }
}

void check_layout(Program& program, const char* lower_right) {
    check_apart(named(program, {"title text:", "title detail:", "title right:"}));
    for (const char* pane : {"Patterns", "Editor", "Physiology", "Perceptual space", lower_right}) {
        CAPTURE(pane);
        REQUIRE(program.shows(std::string("title text:") + pane));
        std::vector<Named> parts;
        for (const char* part : {"title text:", "title detail:", "title right:"}) {
            const auto found = program.places.find(std::string(part) + pane);
            if (found != program.places.end()) parts.push_back({found->first, found->second});
        }
        check_inside(parts, program.at(std::string("pane:") + pane));
    }
    check_apart(named(program, {"entry:", "slider:", "field label:", "link:", "rhythm",
                                "choice:", "radio:", "reset:", "table:", "tab:"}));
    check_apart(named(program, {"button:", "search", "row name:"}));
    check_inside(named(program, {"button:new", "button:dup", "search", "row name:"}),
                 program.at("pane:Patterns"));
    check_inside(named(program, {"entry:amplitude", "entry:carrier", "entry:mix", "slider:mix",
                                 "entry:attack", "entry:unit", "link:add", "link:remove", "rhythm",
                                 "radio:Ring", "radio:Tremolo", "step:"}),
                 program.at("pane:Editor"));
    check_inside(named(program, {"entry:weight_", "slider:weight_", "choice:", "reset:", "radio:N",
                                 "entry:knot", "table:", "tab:"}),
                 program.at(std::string("pane:") + lower_right));
    check_apart(named(program, {"transport:", "speed:", "playhead", "bar:", "show all", "map:"}));
}

}  // namespace

TEST_CASE("legible: titles, names, sliders and entries keep apart and inside their panes" *
          doctest::test_suite("long")) {
    Program program(long_names());
    program.compute_map();
    program.app.shown_map.cancelled = true;    // the bar has its longest text then
    program.app.timeline.range = {0.0, 0.05};  // and here
    for (const ImVec2 size : {ImVec2{1280.0F, 800.0F}, ImVec2{1600.0F, 1000.0F}}) {
        for (const float scale : {0.75F, 1.0F, 1.5F, 2.0F}) {
            CAPTURE(size.x);
            CAPTURE(scale);
            program.resize(size, scale);
            program.app.layout.bench = BenchTab::matrix;
            program.settle();
            check_layout(program, "Matrix");
            program.app.layout.bench = BenchTab::model;
            program.settle();
            check_layout(program, "Model");
        }
    }
}

TEST_CASE("legible: the title of a wide pane has all its parts, of a narrow one the name") {
    Program program(long_names());
    program.compute_map();
    program.settle();
    CHECK(program.at("title right:Perceptual space").value ==
          program.at("title:Perceptual space").value);
    program.resize({1200.0F, 600.0F}, 2.0F);
    CHECK_FALSE(program.shows("title right:Perceptual space"));
    CHECK(program.shows("title text:Perceptual space"));
}

TEST_CASE("legible: a narrow transport bar keeps Play, the time and the map's button") {
    Program program(short_patterns(2));
    program.app.shown_map.cancelled = true;
    program.settle();
    CHECK(program.shows("transport:back"));
    CHECK(program.at("bar:computing").value == "Map not computed");
    program.resize({760.0F, 600.0F}, 2.0F);
    program.click("pane button:Map");
    CHECK_FALSE(program.shows("bar:whole"));
    CHECK(program.shows("transport:play"));
    CHECK(program.shows("playhead"));
    CHECK(program.shows("map:Compute"));
}

TEST_CASE("legible: a field too far down a large editor is reached by the wheel") {
    Program program(long_names());
    program.resize({1280.0F, 800.0F}, 2.0F);
    const float before = program.at("entry:duration_s").min.y;
    const Place pane = program.at("pane:Editor");
    CHECK(before > pane.max.y);
    program.window.move({(pane.min.x + pane.max.x) / 2.0F, pane.max.y - 40.0F});
    for (int k = 0; k < 60; ++k) {
        push(program.window.input, {program.window.now_s, MouseWheel{0.0F, -1.0F}});
    }
    program.settle();
    CHECK(program.at("entry:duration_s").max.y < pane.max.y);
}

}  // namespace legible_test
