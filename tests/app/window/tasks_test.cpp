// The number of actions of common tasks: clicks, drags, key chords, and typed fields. Every task is
// completed, and its result checked. Where a designer counted an earlier state (47, 24, 24, 6, 7
// and 9 for those named first), the number must be smaller; otherwise not larger than before.

#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>
#include <string>

#include "app/document/editing.h"
#include "app/generate/generate.h"
#include "app/window/window.h"
#include "app/workspaces/workspaces.h"
#include "model/io/set/load.h"
#include "tests/support/felt_program.h"
#include "tests/support/program.h"
#include "tests/support/state_home.h"
#include "tests/support/temporary_folder.h"

namespace tasks_test {

using namespace tact;

namespace {

struct Counted : Program {
    int actions = 0;

    explicit Counted(std::size_t patterns) : Program(short_patterns(patterns)) {
        patterns < 2 ? begin_jobs(app) : compute_map();
    }
    explicit Counted(const PatternSet& set) : Program(set) { compute_map(); }

    void clicks(const std::string& name, bool shift = false) {
        ++actions;
        if (shift) hold(key::kLeftShift, true);
        click(name);
        if (shift) hold(key::kLeftShift, false);
    }
    void right_clicks(const std::string& name) {
        ++actions;
        window.move(at(name).middle());
        window.button(true, 1);
        window.button(false, 1);
        settle();
    }
    void drags(const std::string& from, const std::string& to) {
        ++actions;
        drag(at(from).middle(), at(to).middle(), 4);
    }
    void chord(char32_t sign, bool shift = false) {
        ++actions;
        press(sign, true, shift);
    }
    void keys(int code) {
        ++actions;
        press_key(code);
    }
    // Puts the cursor there without replacing the text.
    void types(const std::string& text) {
        ++actions;
        press('a', true);
        type(text);
        press_key(key::kEnter);
    }
    void fills(const std::string& field, const std::string& text) {
        click(field);
        types(text);
    }
    // The field has buttons at its right.
    void fills_left(const std::string& field, const std::string& text) {
        const Place place = at(field);
        window.move({place.min.x + 10.0F, place.middle().y});
        window.button(true, 0);
        window.button(false, 0);
        settle();
        types(text);
    }

    template <class IsSo>
    void wait_until(IsSo is_so) {
        const auto until = end_of_patience();
        while (!is_so()) {
            REQUIRE(std::chrono::steady_clock::now() < until);
            std::this_thread::sleep_for(std::chrono::milliseconds(2));
            frame();
            continue_exports(app);  // as the window's loop does
        }
        settle();
    }

    const std::vector<Vibration>& all() const { return app.work.document.set.vibrations; }

    void hold(int which, bool down) {
        push(window.input, {window.now_s, KeyChange{which, down, false, 0}});
        settle();
    }
};

}  // namespace

TEST_CASE("tasks: five patterns from nothing, named, each with numbers of its own" *
          doctest::test_suite("long")) {
    Counted program(0);
    program.resize({1600.0F, 1400.0F}, 1.0F);  // all fields are visible, whenever the card appears
    for (int k = 1; k <= 5; ++k) {
        program.chord('n');
        program.keys(key::kF1 + 1);
        program.types("alert " + std::to_string(k));
        program.fills("entry:amplitude_g", "0." + std::to_string(k));
        program.fills("entry:carrier_1_hz", std::to_string(60 * k));
        program.fills("entry:modulation_hz", std::to_string(k));
        program.fills("rhythm", "x-x=--x-");
    }
    REQUIRE(program.all().size() == 5);
    CHECK(program.all()[4].name == "alert 5");
    const Pattern& last = program.pattern(4);
    CHECK(last.amplitude_g == doctest::Approx(0.5));
    CHECK(last.carriers[0].frequency_hz == doctest::Approx(300.0));
    CHECK(last.modulation.frequency_hz == doctest::Approx(5.0));
    CHECK(last.rhythm.text == "x-x=--x-");
    CHECK(program.actions == 35);  // 47 before
}

TEST_CASE("tasks: several changed at once, doubled, moved, locked, found, deleted, taken back") {
    Counted program(5);
    program.clicks("row:p1");
    program.clicks("row:p3", true);
    program.fills("entry:amplitude_g", "1.25");
    for (const std::size_t k : {0U, 1U, 2U}) CHECK(program.pattern(k).amplitude_g == 1.25);
    program.chord('d');
    CHECK(program.all().size() == 8);
    program.drags("row:p5", "row:p1");
    CHECK(program.all()[0].name == "p5");
    program.chord('l');
    CHECK(program.all()[0].locked);
    program.fills("search", "p4");
    program.clicks("row:p4");
    program.keys(key::kDelete);
    CHECK(program.all().size() == 7);
    program.chord('z');
    CHECK(program.all().size() == 8);
    CHECK(program.actions == 10);  // 24 before
}

TEST_CASE("tasks: candidates, the most distinct of them with one kept and one left out, exported" *
          doctest::test_suite("long")) {
    const TemporaryFolder folder;
    Counted program(1);
    program.chord('g');
    program.fills("generate:amplitude", "0.6, 1.3");
    program.fills("generate:carrier 1 steps", "3");
    program.fills("generate:modulation", "0, 11");
    // The same number of entries as before.
    program.wait_until(
        [&] { return bool(current_plan(program.app.work, program.app.generating)); });
    program.settle();  // its message moves the buttons
    CHECK(program.at("generate:count").value == "12 patterns");
    program.clicks("button:add candidates");
    program.clicks("workspace:Select");
    program.wait_for_exact_map();
    program.clicks("candidate:" + program.all()[1].name);
    program.chord('l');
    program.clicks("candidate:" + program.all()[2].name);
    program.chord('l', true);
    program.wait_for_exact_map();
    program.wait_until([&] { return program.shows("subset:weakest"); });
    program.clicks("link:export subset");
    program.types((folder.path / "chosen").string());
    program.wait_until([&] { return !program.app.ui.chooser.is_open; });
    CHECK(program.all()[1].locked);
    CHECK(program.all()[2].dropped);
    program.wait_until([&] { return std::filesystem::exists(folder.path / "chosen"); });
    CHECK(program.actions == 12);  // 24 before
}

// Three levels of five numbers; the weakest are below every threshold.
static PatternSet candidates_243() {
    PatternSet set = short_patterns(243);
    std::size_t k = 0;
    for (const double amplitude_g : {0.0001, 0.5, 1.2}) {
        for (const double carrier_hz : {60.0, 120.0, 240.0}) {
            for (const double second_hz : {80.0, 160.0, 300.0}) {
                for (const double mix : {0.1, 0.5, 0.9}) {
                    for (const double modulation_hz : {0.0, 20.0, 40.0}) {
                        auto& pattern = std::get<Pattern>(set.vibrations[k++].source);
                        pattern.duration_s = 0.05;
                        pattern.amplitude_g = amplitude_g;
                        pattern.carriers = {{carrier_hz, 1.0 - mix}, {second_hz, mix}};
                        pattern.modulation.frequency_hz = modulation_hz;
                    }
                }
            }
        }
    }
    set.duration_s = 0.05;
    return set;
}

TEST_CASE("tasks: of 243 candidates those not felt left out, and ten picked" *
          doctest::test_suite("long")) {
    Counted program(candidates_243());
    begin_jobs(program.app);
    program.clicks("workspace:Select");
    program.clicks("candidates:exclude unfelt");
    program.fills_left("subset:count", "10");
    program.wait_until([&] { return program.app.work.selection.picked.size() == 10; });
    std::size_t unfelt = 0;
    for (const Vibration& one : program.all()) {
        const bool weak = std::get<Pattern>(one.source).amplitude_g < 0.001;
        unfelt += weak ? 1 : 0;
        CHECK(one.dropped == weak);
        if (weak) CHECK_FALSE(program.app.work.selection.picked.contains(one.name));
    }
    CHECK(unfelt == 81);
    CHECK(program.actions == 3);
}

TEST_CASE("tasks: a picture of the map in a file") {
    const TemporaryFolder folder;
    Counted program(3);
    program.chord('e');
    program.clicks("export view:space");
    program.clicks("button:choose");
    program.types((folder.path / "map.svg").string());
    program.wait_until([&] { return std::filesystem::exists(folder.path / "map.svg"); });
    CHECK(program.actions == 4);  // 6 before
}

TEST_CASE("tasks: saved, left, and taken up again as it was, after an accident too" *
          doctest::test_suite("long")) {
    const TemporaryFolder folder;
    const StateHome home(folder.path / "state");
    const std::filesystem::path file = folder.path / "mine.tactspace.json";
    const auto edit = [](App& app) {
        edit_patterns(app.work, [](Pattern& pattern) { pattern.amplitude_g += 0.1; });
        commit_step(app.ui, app.work, "amplitude");
        return app.work.document.set;
    };
    int actions = 0;
    PatternSet left;
    {
        Counted first(0);
        App& app = first.app;
        REQUIRE(start_session(app, {}));
        first.settle();
        const PatternSet saved = edit(app);
        first.chord('s');
        first.types(file.string());
        first.wait_until([&] { return std::filesystem::exists(file); });
        const auto written = load_set(file);
        REQUIRE(written);
        CHECK(written->set == saved);
        left = edit(app);
        first.chord('q');
        first.keys(key::kEnter);  // told once: unsaved changes are kept
        REQUIRE(app.ui.quit);
        end_session(app);
        actions += first.actions;
    }
    {
        Counted second(0);
        App& app = second.app;
        REQUIRE(start_session(app, {}));
        second.settle();
        CHECK(app.work.document.set == left);
        CHECK(app.work.document.path == file);
        left = edit(app);
        second.wait_until([&] { return is_autosaving(app.work); });
        wait_for_autosave(app.work);
        actions += second.actions;
    }  // killed: the session does not end
    Counted third(0);
    REQUIRE(start_session(third.app, {}));
    third.settle();
    CHECK(third.app.work.document.set == left);
    CHECK_FALSE(third.app.work.document.set == third.app.work.document.saved);
    end_session(third.app);
    CHECK(actions + third.actions == 4);  // 7 before
}

TEST_CASE("tasks: an output chosen and tried, a pattern felt, then two in turn, all silenced") {
    Counted program(2);
    PlayState& play = program.app.play;
    (void)plug_in(program.app, "memory");
    program.settle();
    program.clicks("device");
    program.clicks("device:" + play.listed->front().id);
    REQUIRE(play.choice.id == play.listed->front().id);
    MemoryDevice* const device = plug_in(program.app, "memory");  // it opens
    program.settle();
    program.clicks("menu:Play");
    program.clicks("menu:Test buzz");
    CHECK(device->begun() == 1);
    device->end();
    program.settle();
    program.keys(key::kSpace);
    CHECK(device->begun() == 2);
    CHECK(is_sounding(play));
    program.clicks("transport:A|B");
    CHECK(program.at("alternate:pair").value == "A p1 | B p2");
    CHECK(is_sounding(play));
    program.keys(key::kEscape);
    CHECK_FALSE(device->playing());
    CHECK_FALSE(is_sounding(play));
    CHECK(program.actions == 7);  // 9 before
}

TEST_CASE("tasks: the closest pair parted by what is suggested") {
    Counted program(4);
    program.wait_until([&] { return program.shows("neighbour:separate closest"); });
    const auto before = program.app.work.document.set;
    program.clicks("neighbour:separate closest");
    program.wait_until([&] { return program.shows("apply:0"); });
    program.clicks("apply:0");
    CHECK_FALSE(program.app.work.document.set == before);
    CHECK(program.actions == 2);
}

TEST_CASE("tasks: a rhythm from the list, patterns like one, two compared stage by stage" *
          doctest::test_suite("long")) {
    Counted program(4);
    program.resize({1600.0F, 1400.0F}, 1.0F);
    SUBCASE("a rhythm") {
        program.clicks("link:rhythms");
        program.clicks("rhythm list:Euclidean");
        const auto row = std::ranges::find_if(program.places, [](const auto& place) {
            return place.first.starts_with("rhythm:") && place.first != "rhythm:";
        });
        REQUIRE(row != program.places.end());
        const std::string name = row->first;
        program.clicks(name);
        CHECK("rhythm:" + program.pattern(0).rhythm.text == name);
        CHECK(program.actions == 3);
    }
    SUBCASE("patterns like one") {
        program.right_clicks("row:p2");
        program.clicks("row menu:Find similar");
        CHECK(program.app.work.selection.current == 1);
        CHECK_FALSE(program.app.work.selection.others.empty());
        CHECK(program.actions == 2);
    }
    SUBCASE("two compared") {
        program.clicks("workspace:Physiology");
        program.clicks("compare with");
        program.clicks("pin:p3");
        CHECK(program.app.work.selection.pinned == "p3");
        CHECK(program.actions == 3);
    }
    SUBCASE("one renamed in the map that a search hides from the list") {
        program.fills("search", "p1");
        program.right_clicks("point:p3");
        program.clicks("row menu:Rename");
        program.types("knock");
        CHECK(program.all()[2].name == "knock");
        CHECK(program.shows("row:knock"));
        CHECK(program.actions == 4);
    }
    SUBCASE("one renamed in the table of candidates") {
        program.clicks("workspace:Select");
        program.right_clicks("candidate:p2");
        program.clicks("row menu:Rename");
        program.types("knock");
        CHECK(program.all()[1].name == "knock");
        CHECK(program.actions == 4);
    }
    SUBCASE("one locked from the map, and another renamed there") {
        program.right_clicks("point:p2");
        program.clicks("row menu:Lock");
        CHECK(program.all()[1].locked);
        program.right_clicks("point:p4");
        program.clicks("row menu:Rename");
        program.types("knock");
        CHECK(program.all()[3].name == "knock");
        CHECK(program.actions == 5);
    }
}

namespace {

// Drawing by hand, in the arrangement for it.
struct Drawn : Counted {
    Drawn() : Counted(0) {
        resize({1600.0F, 1000.0F}, 1.0F);
        app.layout = first_layout(Arrangement::design);
        settle();
        chord('n');
    }
    // Positions as shares of the pattern's length and of the lane's height.
    ImVec2 in_lane(double x, double y) const {
        const Place& lane = at("strip:amplitude");
        return {lane.min.x + static_cast<float>(x / 1.06) * (lane.max.x - lane.min.x),
                lane.max.y - static_cast<float>(y) * (lane.max.y - lane.min.y)};
    }
    void drags_in_lane(ImVec2 from, ImVec2 to) {
        ++actions;
        drag(from, to, 5);
    }
    void drags_in_lane_with_shift(ImVec2 from, ImVec2 to) {
        hold(key::kLeftShift, true);
        drags_in_lane(from, to);
        hold(key::kLeftShift, false);
    }
    void clicks_in_lane(ImVec2 place) {
        ++actions;
        window.click(place);
        settle();
    }
    void letter(char32_t sign) {
        ++actions;
        press(sign, false);
    }
};

}  // namespace

TEST_CASE("tasks: a heartbeat of two notes of unequal strength, drawn") {
    Drawn program;
    program.letter('b');
    program.drags_in_lane(program.in_lane(0.02, 0.3), program.in_lane(0.1, 0.3));
    program.drags_in_lane(program.in_lane(0.27, 0.3), program.in_lane(0.35, 0.3));
    const Place second = program.at("note:1");
    const ImVec2 top{second.middle().x, second.min.y};
    program.drags_in_lane(top, {top.x, second.max.y - 5.0F / 9.0F * (second.max.y - top.y)});
    CHECK(program.pattern(0).rhythm.text == "x=--5=----------");
    CHECK(program.actions == 5);  // at most 6 were required
}

TEST_CASE("tasks: a bar copied four times") {
    Drawn program;
    program.letter('b');
    // The bar is there: two notes in the first half of a second.
    for (const double from : {0.02, 0.27}) {
        program.drag(program.in_lane(from, 0.3), program.in_lane(from + 0.08, 0.3), 5);
    }
    REQUIRE(program.pattern(0).rhythm.text == "x=--x=----------");
    program.actions = 0;
    // From the empty place behind the notes back to the start.
    program.drags_in_lane_with_shift(program.in_lane(0.5, 0.3), program.in_lane(0.0, 0.3));
    program.letter('r');
    CHECK(program.pattern(0).rhythm.text == "x=--x=--x=--x=--x=--x=--x=--x=--");
    CHECK(program.pattern(0).duration_s == doctest::Approx(0.2));
    CHECK(program.actions == 2);  // 3 at most
    program.press('z', true);
    CHECK(program.pattern(0).rhythm.text == "x=--x=----------");
    CHECK(program.pattern(0).duration_s == doctest::Approx(0.1));
}

TEST_CASE("tasks: a rising sweep, drawn") {
    Drawn program;
    const Place lane = program.at("strip:frequency");
    program.clicks_in_lane(lane.middle());
    REQUIRE(program.pattern(0).frequency_curve.size() == 3);
    const ImVec2 end = program.at("grip:frequency curve:2").middle();
    program.drags_in_lane(end, {end.x, lane.min.y + 4.0F});
    const FrequencyCurve& curve = program.pattern(0).frequency_curve;
    CHECK(curve.back().frequency_hz > 1.4 * curve.front().frequency_hz);
    CHECK(program.actions == 3);  // 4 at most
}

TEST_CASE("tasks: three ticks over a soft bed, and the same at 1.5 times the tempo") {
    Drawn program;
    program.fills("entry:amplitude_g", "0.2");
    program.letter('k');
    for (const double at : {0.2, 0.5, 0.8}) program.clicks_in_lane(program.in_lane(at, 0.9));
    REQUIRE(program.pattern(0).transients.size() == 3);
    CHECK(program.pattern(0).amplitude_g == doctest::Approx(0.2));
    CHECK(program.actions == 6);  // 8 at most
    program.press('b', false);
    program.drag(program.in_lane(0.02, 0.2), program.in_lane(0.1, 0.2), 5);
    const double step_s = program.pattern(0).rhythm.unit_s;
    program.actions = 0;
    program.clicks("entry:tempo_bpm");
    program.types("*1.5");
    CHECK(program.pattern(0).rhythm.unit_s == doctest::Approx(step_s / 1.5));
    CHECK(program.actions == 2);
}

}  // namespace tasks_test
