#include "app/window/window.h"

#include <chrono>

#include "app/document/editing.h"
#include "app/map/map.h"
#include "app/workspaces/workspaces.h"
#include "tests/support/patience.h"
#include "tests/support/program.h"

namespace frame_test {

using namespace tact;

TEST_CASE("window: one drag of a slider is one undo step") {
    Program program(short_patterns(3));
    const Place bar = program.at("slider:amplitude_g");
    const double before_g = program.pattern(0).amplitude_g;
    const float y = bar.middle().y;
    program.drag({bar.min.x + 20.0F, y}, {bar.max.x - 10.0F, y}, 6);
    const double after_g = program.pattern(0).amplitude_g;
    CHECK(after_g > before_g);

    program.press('z', true);
    CHECK(program.pattern(0).amplitude_g == before_g);
    CHECK(program.app.work.document.history.undo_label() == nullptr);
    program.press('z', true, true);
    CHECK(program.pattern(0).amplitude_g == after_g);
    program.press('z', true);
    program.press('y', true);
    CHECK(program.pattern(0).amplitude_g == after_g);
}

TEST_CASE("window: a hundred steps and more can be undone" * doctest::test_suite("long")) {
    Program program(short_patterns(1));
    for (int k = 0; k < 120; ++k) program.press('d', true);
    CHECK(program.app.work.document.set.vibrations.size() == 121);
    for (int k = 0; k < 120; ++k) program.press('z', true);
    CHECK(program.app.work.document.set == short_patterns(1));
}

TEST_CASE("window: a typed number is taken exactly, beyond the slider too, and clamped to range") {
    Program program(short_patterns(2));
    const auto enter = [&](const std::string& text) {
        program.click("entry:amplitude_g");
        program.window.type(text);
        program.window.press(key::kEnter);
        program.settle();
    };
    enter("12.345");
    CHECK(program.pattern(0).amplitude_g == 12.345);
    enter("999");
    CHECK(program.pattern(0).amplitude_g == limits::kAmplitudeG.high);
    CHECK(program.pattern(1).amplitude_g == 1.0);
}

TEST_CASE("window: arrow keys nudge the field touched last, Shift five times as far") {
    Program program(short_patterns(1));
    program.click("slider:modulation_hz");
    const double start_hz = program.pattern(0).modulation.frequency_hz;
    program.press_key(key::kRight);
    const double step_hz = program.pattern(0).modulation.frequency_hz - start_hz;
    // 0.1 s patterns have bins of 10 Hz: the smallest step without leakage.
    CHECK(step_hz == 10.0);
    program.press_key(key::kLeft);
    CHECK(program.pattern(0).modulation.frequency_hz == start_hz);
}

TEST_CASE("window: several selected patterns are edited together, locked ones stay") {
    PatternSet set = short_patterns(4);
    set.vibrations[2].locked = true;
    Program program(set);
    program.press('a', true);
    program.click("entry:amplitude_g");
    program.window.type("2");
    program.window.press(key::kEnter);
    program.settle();
    CHECK(program.pattern(0).amplitude_g == 2.0);
    CHECK(program.pattern(1).amplitude_g == 2.0);
    CHECK(program.pattern(2).amplitude_g == 1.0);
    CHECK(program.pattern(3).amplitude_g == 2.0);
    program.press('z', true);
    CHECK(program.app.work.document.set == set);
}

TEST_CASE("window: new, duplicate, delete, copy and paste are one step each") {
    Program program(short_patterns(2));
    program.click("button:new");
    CHECK(program.app.work.document.set.vibrations.size() == 3);
    CHECK(program.app.work.selection.current == 1);
    program.press('d', true);
    program.press('c', true);
    program.press('v', true);
    CHECK(program.app.work.document.set.vibrations.size() == 5);
    program.press_key(key::kDelete);
    CHECK(program.app.work.document.set.vibrations.size() == 4);
    for (int k = 0; k < 4; ++k) program.press('z', true);
    CHECK(program.app.work.document.set == short_patterns(2));
}

TEST_CASE("window: a rhythm is typed, or clicked step by step") {
    Program program(short_patterns(1));
    program.click("rhythm");
    program.window.type("x--");
    program.window.press(key::kEnter);
    program.settle();
    CHECK(program.pattern(0).rhythm.text == "x--");
    program.click("step:1");
    CHECK(program.pattern(0).rhythm.text == "xx-");
    program.click("step:1");
    CHECK(program.pattern(0).rhythm.text == "x=-");
    program.click("step:0");  // a hold needs its note
    CHECK(program.pattern(0).rhythm.text == "---");
}

TEST_CASE("window: a rhythm that is none is refused in words and changes nothing") {
    Program program(short_patterns(1));
    program.click("rhythm");
    program.window.type("q=x");
    program.window.press(key::kEnter);
    program.settle();
    CHECK(program.pattern(0).rhythm.text.empty());
    CHECK(program.app.ui.status.is_error);
    CHECK(program.app.ui.status.text.find("step 1") != std::string::npos);
}

TEST_CASE("window: a name twice or no name is refused, the old one stays") {
    Program program(short_patterns(2));
    rename_vibration(program.app.ui, program.app.work, 0, "p2");
    CHECK(program.app.ui.status.is_error);
    rename_vibration(program.app.ui, program.app.work, 0, "");
    CHECK(program.app.work.document.set == short_patterns(2));
    rename_vibration(program.app.ui, program.app.work, 0, "tap");
    CHECK(program.app.work.document.set.vibrations[0].name == "tap");
}

TEST_CASE("window: no set, one pattern, hundreds of patterns all have something to say") {
    for (const std::size_t count : {0UL, 1UL, 2UL, 400UL}) {
        Program program(short_patterns(count));
        CHECK(program.shows("title:Perceptual space"));
        CHECK(program.at("title:Patterns").value == std::to_string(count));
        program.press_key(key::kDown);
        program.press_key(key::kDelete);
        program.press('a', true);
        program.press('3', true);
        program.press('1', true);
        program.press('3');  // no pattern is picked
    }
}

TEST_CASE("window: a pane is maximised by a double click on its title, Esc puts it back") {
    Program program(short_patterns(2));
    const ImVec2 title = program.at("title:Perceptual space").middle();
    program.window.click(title);
    program.window.click(title);
    program.settle();
    CHECK_FALSE(program.shows("title:Patterns"));
    program.press_key(key::kEscape);
    CHECK(program.shows("title:Patterns"));
}

TEST_CASE("window: a dragged splitter moves its panes") {
    Program program(short_patterns(2));
    const float before = program.at("title:Physiology").min.x;
    const ImVec2 bar = program.at("splitter:left").middle();
    program.drag(bar, bar + ImVec2(80.0F, 0.0F), 4);
    CHECK(std::abs(program.at("title:Physiology").min.x - before - 80.0F) <= 3.0F);
}

TEST_CASE("window: keys make the pane in use wider, narrower, higher and lower") {
    Program program(short_patterns(2));
    const auto size_of = [&](const std::string& pane) {
        const Place& place = program.at("pane:" + pane);
        return place.max - place.min;
    };
    constexpr int kWidth = key::kF1 + 6;
    constexpr int kHeight = key::kF1 + 7;
    for (const char* pane : {"Patterns", "Editor", "Physiology", "Perceptual space", "Matrix"}) {
        CAPTURE(pane);
        program.window.click(program.at(std::string("title:") + pane).middle());
        program.settle();
        const ImVec2 before = size_of(pane);
        program.press_key(kWidth);
        CHECK(size_of(pane).x > before.x + 10.0F);
        program.press_key(kWidth, false, true);
        CHECK(std::abs(size_of(pane).x - before.x) <= 1.0F);
        const bool fills_column = std::string_view(pane) == "Physiology";
        program.press_key(kHeight);
        CHECK((size_of(pane).y > before.y + 10.0F) == !fills_column);
        program.press_key(kHeight, false, true);
        CHECK(std::abs(size_of(pane).y - before.y) <= 1.0F);
    }
    CHECK(program.app.ui.status.text == "Matrix: lower");
}

TEST_CASE("design: all numbers of a pattern are in sight at every size of text") {
    struct Screen {
        ImVec2 size;
        float scale;
    };
    for (const Screen& screen :
         {Screen{{1600.0F, 1000.0F}, 1.0F}, Screen{{1600.0F, 1000.0F}, 1.5F},
          Screen{{1600.0F, 1000.0F}, 2.0F}, Screen{{1280.0F, 720.0F}, 1.0F}}) {
        CAPTURE(screen.size.x);
        CAPTURE(screen.scale);
        Program program(short_patterns(2));
        program.resize(screen.size, screen.scale);
        program.app.layout = first_layout(Arrangement::design);
        program.settle();
        const Place pane = program.at("pane:Editor");
        for (const char* name : {"entry:amplitude_g", "entry:carrier_1_hz", "entry:modulation_hz",
                                 "entry:depth", "radio:Ring", "radio:Tremolo", "rhythm",
                                 "entry:attack_ms", "entry:release_ms", "entry:duration_s"}) {
            CAPTURE(name);
            REQUIRE(program.shows(name));
            CHECK(program.at(name).min.y > pane.min.y);
            CHECK(program.at(name).max.y <= pane.max.y - program.app.ui.theme.padding_px);
            CHECK(program.at(name).max.x <= pane.max.x);
        }
        // The map can be enlarged with its bar, and with keys.
        const ImVec2 bar = program.at("splitter:band").middle();
        program.drag(bar, bar + ImVec2{0.0F, 60.0F}, 4);
        CHECK(program.at("pane:Editor").min.y > pane.min.y + 50.0F);
        program.click("title:Editor");
        program.press_key(key::kF1 + 7);
        CHECK(program.at("pane:Editor").min.y < pane.min.y + 50.0F);
    }
}

TEST_CASE("design: no number moves when the map comes and the closest pattern is known") {
    for (const ImVec2 size : {ImVec2{1280.0F, 720.0F}, ImVec2{1600.0F, 1000.0F}}) {
        CAPTURE(size.x);
        PatternSet set = short_patterns(4);
        // too close, which the text tells as well
        set.vibrations[1].source = set.vibrations[0].source;
        Program program(set);
        program.resize(size, 1.0F);
        program.app.layout = first_layout(Arrangement::design);
        program.settle();
        REQUIRE_FALSE(program.shows("neighbour:name"));
        const Place before = program.at("entry:carrier_1_hz");
        program.compute_map();
        program.settle();
        REQUIRE(program.shows("neighbour:name"));
        CHECK(program.at("entry:carrier_1_hz").min.y == before.min.y);
        CHECK(program.at("entry:carrier_1_hz").min.x == before.min.x);
    }
}

TEST_CASE("window: a pane that can be no wider says so, and the next key narrows it at once") {
    Program program(short_patterns(2));
    program.click("title:Editor");
    for (int k = 0; k < 40; ++k) program.press_key(key::kF1 + 6);
    CHECK(program.app.ui.status.text == "Editor cannot be wider");
    const float widest = program.at("pane:Editor").max.x;
    program.press_key(key::kF1 + 6, false, true);
    CHECK(program.at("pane:Editor").max.x < widest - 10.0F);
}

TEST_CASE("window: a key maximises the pane in use, and puts it back") {
    Program program(short_patterns(2));
    program.click("title:Editor");
    program.press_key(key::kF1 + 5);
    CHECK(program.app.layout.maximised == Pane::editor);
    program.press_key(key::kF1 + 6);  // no other pane has room to give
    program.press_key(key::kF1 + 5);
    CHECK_FALSE(program.app.layout.maximised);
    CHECK(program.app.in_use.wider == 0);
}

TEST_CASE("window: the command palette finds a command and runs it") {
    Program program(short_patterns(2));
    program.press('p', true);
    REQUIRE(program.app.palette.open);
    program.window.type("duplic");
    program.settle();
    program.press_key(key::kEnter);
    CHECK_FALSE(program.app.palette.open);
    CHECK(program.app.work.document.set.vibrations.size() == 3);
}

TEST_CASE("window: Ctrl+Z in a text field is the field's own") {
    Program program(short_patterns(2));
    program.press('d', true);
    program.click("search");
    program.window.type("ab");
    program.settle();
    program.press('z', true);
    CHECK(program.app.work.document.set.vibrations.size() == 3);
}

TEST_CASE("window: a number being typed is taken however its entry is left, for its own pattern") {
    Program program(short_patterns(3));
    program.click("entry:amplitude_g");
    program.window.type("3.3");
    program.settle();
    program.click("row:p2");
    CHECK(program.pattern(0).amplitude_g == 3.3);
    CHECK(program.pattern(1).amplitude_g == 1.0);
    CHECK(program.app.work.selection.current == 1);
    program.click("entry:amplitude_g");
    program.window.type("1,5");
    program.window.press(key::kTab);
    program.settle();
    CHECK(program.pattern(1).amplitude_g == 1.5);
}

TEST_CASE("window: locking is an edit, and what is locked is not deleted") {
    Program program(short_patterns(2));
    program.press('l', true);
    program.settle();
    CHECK(program.app.work.unsaved);
    program.press_key(key::kDelete);
    CHECK(program.app.work.document.set.vibrations.size() == 2);
    program.press('z', true);
    program.press_key(key::kDelete);
    CHECK(program.app.work.document.set.vibrations.size() == 1);
}

TEST_CASE("window: an error at the foot goes by its x and by Esc, what is no error has no x") {
    Program program(short_patterns(2));
    for (const bool by_mouse : {true, false}) {
        complain(program.app.ui, "There is no such file.");
        program.settle();
        if (by_mouse) program.click("status:dismiss");
        if (!by_mouse) program.press_key(key::kEscape);
        CHECK(program.app.ui.status.text.empty());
    }
    say(program.app.ui, "Saved.");
    program.settle();
    CHECK(program.shows("status"));
    CHECK_FALSE(program.shows("status:dismiss"));
}

TEST_CASE("window: the bar stays where it is, whatever is named, zoomed or computed") {
    Program program(short_patterns(3));
    choose_pair(program.app.work, 0, 1);
    for (const ImVec2 size : {ImVec2{1280.0F, 720.0F}, ImVec2{1000.0F, 720.0F}}) {
        CAPTURE(size.x);
        program.resize(size, 1.0F);
        const auto before = program.places;
        const auto check = [&](const char* change) {
            CAPTURE(change);
            program.settle();
            for (const char* name :
                 {"transport:loop", "transport:A|B", "device", "speed:1\u00d7", "playhead"}) {
                CAPTURE(name);
                CHECK(program.shows(name) == before.contains(name));
                if (!program.shows(name)) continue;
                CHECK(program.at(name).min.x == before.at(name).min.x);
            }
        };
        auto& all = program.app.work.document.edit().vibrations;
        all[0].name = "a name that is rather longer than it would have to be";
        check("a long name");
        program.app.timeline.range = {0.0, 0.05};
        check("a zoomed time");
        program.app.shown_map.cancelled = true;
        check("a map that is not computed");
        all[0].name = "p1";
        program.app.timeline.range = {};
        program.app.shown_map.cancelled = false;
        program.settle();
    }
}

TEST_CASE(
    "window: a frame draws one of a new map, new stages and new thumbnails, none waits long") {
    Program program(short_patterns(12));
    App& app = program.app;
    program.compute_map();
    program.wait_for_stages();
    for (int edit = 1; edit <= 5; ++edit) {
        for (Vibration& vibration : app.work.document.edit().vibrations) {
            std::get<Pattern>(vibration.source).modulation.frequency_hz = 10.0 * edit;
        }
        document_changed(app.work);
        const auto is_done = [&] {
            return map_state(app.work, app.shown_map) == MapState::exact &&
                   app.physiology.stages == app.physiology.stages_job.current() &&
                   !app.work.cache.behind;
        };
        const auto until = end_of_patience();
        do {
            REQUIRE(std::chrono::steady_clock::now() < until);
            const auto map = app.shown_map.transition.shown;
            const auto stages = app.physiology.stages;
            const bool stages_waited = app.physiology.put_off;
            const bool thumbnails_waited = app.work.cache.put_off;
            program.frame();
            const bool has_map = app.shown_map.transition.shown != map;
            const bool has_stages = app.physiology.stages != stages;
            CHECK(!(has_map && has_stages && !stages_waited));
            CHECK(!(stages_waited && app.physiology.put_off));
            CHECK(app.work.cache.put_off == (has_stages && !thumbnails_waited));
            CHECK((!app.work.cache.put_off || app.work.cache.samples_left == 0));
        } while (!is_done());
    }
}

TEST_CASE("window: a strength that is not known yet is not told as 0 g") {
    Program program(short_patterns(12));
    begin_jobs(program.app);
    program.app.work.cache.entries.clear();
    program.frame();
    for (const auto& [name, place] : program.places) {
        if (name.starts_with("strength:")) CHECK(place.value != "0 g");
    }
    program.settle();
    CHECK(program.at("strength:p12").value.ends_with(" g"));
    CHECK(program.at("strength:p12").value != "0 g");
}

}  // namespace frame_test
