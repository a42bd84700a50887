// The wave strip in the program's frames: by mouse and keys.

#include "app/wave_strip/wave_strip.h"

#include <algorithm>

#include "app/document/editing.h"
#include "app/screen/screen.h"
#include "app/workspaces/workspaces.h"
#include "model/set/measured_twin.h"
#include "tests/support/program.h"

namespace wave_strip_test {

using namespace tact;

namespace {

struct Strip : Program {
    Strip() : Program(short_patterns(2)) {}

    Pattern& pattern() { return std::get<Pattern>(app.work.document.edit().vibrations[0].source); }
    // A position in the amplitude lane as shares from its lower left corner.
    ImVec2 in_lane(float x, float y) const {
        const Place& lane = at("strip:amplitude");
        return {lane.min.x + x * (lane.max.x - lane.min.x),
                lane.max.y - y * (lane.max.y - lane.min.y)};
    }
    // The amplitude line stands at 1 / 1.2 of the lane's height.
    ImVec2 on_line(float x) const { return in_lane(x, 1.0F / 1.2F); }
    void click_at(ImVec2 place) {
        window.click(place);
        settle();
    }
    std::string last_step() const {
        const std::string* label = app.work.document.history.undo_label();
        return label == nullptr ? "" : *label;
    }
};

}  // namespace

TEST_CASE("wave strip: a drag of the top edge is one step that changes the amplitude") {
    Strip strip;
    const double before = strip.pattern().amplitude_g;
    strip.drag(strip.on_line(0.4F), strip.in_lane(0.4F, 0.4F), 6);
    CHECK(strip.pattern().amplitude_g < 0.6 * before);
    CHECK(strip.pattern().amplitude_curve.empty());
    CHECK(strip.last_step() == "Change amplitude of p1");
    undo(strip.app.ui, strip.app.work);
    CHECK(strip.pattern().amplitude_g == before);
}

TEST_CASE(
    "wave strip: with several patterns selected the top edge moves all, a point only its own") {
    Strip strip;
    select_all(strip.app.work);
    strip.settle();
    strip.drag(strip.on_line(0.4F), strip.in_lane(0.4F, 0.4F), 4);
    const auto& set = strip.app.work.document.set;
    CHECK(std::get<Pattern>(set.vibrations[1].source).amplitude_g == strip.pattern().amplitude_g);
    strip.click_at(strip.on_line(0.4F));
    CHECK(strip.pattern().amplitude_curve.size() == 3);
    CHECK(std::get<Pattern>(set.vibrations[1].source).amplitude_curve.empty());
}

TEST_CASE("wave strip: a drawn frequency is dragged alone, and the step says so") {
    Strip strip;
    strip.pattern().frequency_curve = {{0.0, 100.0}, {strip.pattern().duration_s, 200.0}};
    document_changed(strip.app.work);
    commit_step(strip.app.ui, strip.app.work, "Draw");
    select_all(strip.app.work);
    strip.settle();
    const Vibration other = strip.app.work.document.set.vibrations[1];
    const Place lane = strip.at("strip:frequency");
    const FrequencyCurve before = strip.pattern().frequency_curve;
    const auto on_curve = [&](float y) {
        return ImVec2{lane.min.x + 0.45F * (lane.max.x - lane.min.x), y};
    };
    for (float y = lane.min.y; y < lane.max.y && strip.pattern().frequency_curve == before;
         y += 6.0F) {
        strip.drag(on_curve(y), on_curve(y + 12.0F), 4);
    }
    CHECK(strip.pattern().frequency_curve != before);
    CHECK(strip.app.work.document.set.vibrations[1] == other);
    CHECK(strip.last_step().ends_with(" of p1"));
}

TEST_CASE("wave strip: a click on the line makes a point, Del removes it and not the pattern") {
    Strip strip;
    strip.click_at(strip.on_line(0.4F));
    REQUIRE(strip.pattern().amplitude_curve.size() == 3);
    CHECK(strip.last_step() == "Add point to amplitude curve of p1");
    CHECK(strip.shows("entry:chosen_value"));
    strip.press_key(key::kDelete);
    CHECK(strip.pattern().amplitude_curve.size() == 2);
    CHECK(strip.app.work.document.set.vibrations.size() == 2);
    CHECK(!strip.shows("entry:chosen_value"));
    strip.press_key(key::kDelete);
    CHECK(strip.app.work.document.set.vibrations.size() == 1);
}

TEST_CASE("wave strip: the chosen point is typed and nudged") {
    Strip strip;
    strip.click_at(strip.on_line(0.4F));
    strip.press_key(key::kLeft);
    CHECK(strip.pattern().amplitude_curve[1].value == doctest::Approx(0.95));
    strip.click("entry:chosen_value");
    strip.type("40");
    strip.press_key(key::kEnter);
    CHECK(strip.pattern().amplitude_curve[1].value == doctest::Approx(0.4));
}

TEST_CASE("wave strip: a double click makes a transient where there is none, and removes one") {
    Strip strip;
    const auto twice = [&](ImVec2 place) {
        strip.click_at(place);
        strip.click_at(place);
    };
    twice(strip.in_lane(0.5F, 0.3F));
    REQUIRE(strip.pattern().transients.size() == 1);
    const Transient& transient = strip.pattern().transients[0];
    CHECK(transient.time_s == doctest::Approx(0.5 * 1.06 * 0.1).epsilon(0.06));
    CHECK(transient.amplitude_g == doctest::Approx(0.36).epsilon(0.05));
    strip.click_at(strip.in_lane(0.1F, 0.1F));
    twice(strip.at("grip:transient:0").middle());
    CHECK(strip.pattern().transients.empty());
}

TEST_CASE("wave strip: a note is dragged as one step, and double clicks remove and add notes") {
    Strip strip;
    strip.pattern().rhythm = {"x=--x=--", strip.pattern().duration_s / 8.0};
    document_changed(strip.app.work);
    commit_step(strip.app.ui, strip.app.work, "Tap");
    strip.settle();
    const Place second = strip.at("note:1");
    const float step = 0.5F * (second.max.x - second.min.x);
    const float y = 0.5F * (second.min.y + second.max.y);
    strip.drag({second.max.x, y}, {second.max.x + step, y - 20.0F}, 5);
    CHECK(strip.pattern().rhythm.text == "x=--x==-");
    CHECK(strip.last_step() == "Change rhythm of p1");
    const auto double_click = [&](ImVec2 place) {
        strip.window.click(place);
        strip.click_at(place);
    };
    double_click({second.min.x + 1.5F * step, y});
    CHECK(strip.pattern().rhythm.text == "x=------");
    CHECK(strip.last_step() == "Remove a note from rhythm of p1");
    double_click({second.min.x + 0.5F * step, y});
    CHECK(strip.pattern().rhythm.text == "x=--x---");
    CHECK(strip.pattern().transients.empty());
}

TEST_CASE("wave strip: points are added and chosen by keys alone") {
    Strip strip;
    strip.app.timeline.playhead.at_s = 0.05;
    add_at(strip.app.ui, strip.app.work, strip.app.pattern_panes.strip, GripKind::level, 0.05);
    strip.settle();
    CHECK(strip.pattern().amplitude_curve.size() == 3);
    strip.press(U'n');
    CHECK(strip.app.pattern_panes.strip.chosen == Grip{GripKind::amplitude_point, 2});
    strip.press(U'n', false, true);
    strip.press(U'n', false, true);
    CHECK(strip.app.pattern_panes.strip.chosen == Grip{GripKind::amplitude_point, 0});
    strip.press_key(key::kLeft);
    CHECK(strip.pattern().amplitude_curve[0].value < 1.0);
    strip.press_key(key::kDelete);
    CHECK(strip.pattern().amplitude_curve.size() == 2);
}

TEST_CASE("wave strip: a carrier whose frequency is drawn has no slider of its own") {
    Strip strip;
    const double hz = strip.pattern().carriers[0].frequency_hz;
    strip.pattern().frequency_curve = {{0.0, 80.0}};
    document_changed(strip.app.work);
    strip.settle();
    strip.click("entry:carrier_1_hz");
    strip.type("200");
    strip.press_key(key::kEnter);
    CHECK(strip.pattern().carriers[0].frequency_hz == hz);
}

TEST_CASE("wave strip: nothing of a locked pattern can be taken") {
    Strip strip;
    toggle_locked(strip.app.ui, strip.app.work);
    strip.settle();
    const Pattern before = strip.pattern();
    strip.drag(strip.on_line(0.4F), strip.in_lane(0.4F, 0.4F), 4);
    strip.click_at(strip.on_line(0.6F));
    CHECK(strip.pattern() == before);
}

TEST_CASE("wave strip: the wheel zooms in time at the mouse, and the pane does not scroll") {
    Strip strip;
    strip.pattern().attack_s = 0.01;
    document_changed(strip.app.work);
    strip.settle();
    const float before = strip.at("grip:attack:0").middle().x;
    const float top = strip.at("wave strip").min.y;
    strip.window.move({before, strip.in_lane(0.5F, 0.5F).y});
    strip.settle();
    push(strip.window.input, {strip.window.now_s, MouseWheel{0.0F, 3.0F}});
    strip.settle();
    CHECK(strip.at("grip:attack:0").middle().x == doctest::Approx(before).epsilon(0.01));
    CHECK(strip.app.timeline.range.length_s() > 0.0);
    CHECK(strip.at("wave strip").min.y == top);
}

namespace {

// The layout for design, in which the strip has its tools.
struct Band : Strip {
    Band() {
        resize({1600.0F, 1000.0F}, 1.0F);
        app.layout = first_layout(Arrangement::design);
        settle();
    }
    const std::string& rhythm() { return pattern().rhythm.text; }
};

}  // namespace

TEST_CASE("wave strip: with its tool a drag on nothing draws a note, one step each") {
    Band strip;
    strip.press('b', false);
    CHECK(strip.at("strip tool").value == "Notes");
    const float end = 1.0F / 1.06F;  // the lane shows a little more than the pattern
    strip.drag(strip.in_lane(0.03F * end, 0.3F), strip.in_lane(0.2F * end, 0.3F), 6);
    CHECK(strip.rhythm() == "x===------------");
    CHECK(strip.last_step() == "Draw a note of rhythm of p1");
    strip.drag(strip.in_lane(0.53F * end, 0.3F), strip.in_lane(0.6F * end, 0.3F), 6);
    CHECK(strip.rhythm() == "x===----x=------");
    CHECK(strip.pattern().rhythm.unit_s == doctest::Approx(strip.pattern().duration_s / 16.0));
    undo(strip.app.ui, strip.app.work);
    CHECK(strip.rhythm() == "x===------------");
    undo(strip.app.ui, strip.app.work);
    CHECK(strip.rhythm().empty());
}

TEST_CASE("wave strip: the top of a note is its strength, its edges its length") {
    Band strip;
    strip.pattern().rhythm = {"x===----x===----", strip.pattern().duration_s / 16.0};
    document_changed(strip.app.work);
    strip.press('b', false);
    strip.settle();
    const Place second = strip.at("note:1");
    const float middle = 0.5F * (second.min.x + second.max.x);
    const float floor = second.max.y;
    strip.drag({middle, second.min.y}, {middle, floor - 5.0F / 9.0F * (floor - second.min.y)}, 6);
    CHECK(strip.rhythm() == "x===----5===----");
    CHECK(strip.last_step() == "Change rhythm of p1");
    const float step = (second.max.x - second.min.x) / 4.0F;
    const float low = floor - 4.0F;  // below the top
    strip.drag({second.max.x - 1.0F, low}, {second.max.x + 2.0F * step, low}, 6);
    CHECK(strip.rhythm() == "x===----5=====--");
    strip.drag({middle, low}, {middle - step, low}, 6);
    CHECK(strip.rhythm() == "x===---5=====---");
}

TEST_CASE("wave strip: a double click where nothing was draws once, and on a note removes it") {
    Band strip;
    strip.press('b', false);
    const ImVec2 place = strip.in_lane(0.3F, 0.3F);
    const auto twice = [&] {
        strip.click_at(place);
        strip.click_at(place);
    };
    twice();
    CHECK(std::ranges::count(strip.rhythm(), 'x') == 1);
    for (int k = 0; k < 60; ++k) strip.frame();  // the next press is another double click
    twice();
    CHECK(std::ranges::count(strip.rhythm(), 'x') == 0);
}

namespace {

// Two bars of a second each, sixteenths.
struct Notes : Band {
    Notes() {
        pattern().rhythm = {"x=--5---", 0.0625};
        pattern().duration_s = 1.0;
        document_changed(app.work);
        commit_step(app.ui, app.work, "Tap");
        press('b', false);
        settle();
    }
    // A position by steps from the start, low in the lane.
    ImVec2 step(double at) const { return in_lane(static_cast<float>(at * 0.0625 / 1.06), 0.05F); }
    void shift(bool down) {
        push(window.input, {window.now_s, KeyChange{key::kLeftShift, down, false, 0}});
        settle();
    }
    void box(double from, double to) {
        shift(true);
        drag(step(from), step(to), 5);
        shift(false);
    }
    const ChosenNotes& chosen() const { return app.pattern_panes.strip.notes; }
};

}  // namespace

TEST_CASE("wave strip: a box chooses its notes, and Ctrl+D has them once more after themselves") {
    Notes strip;
    strip.box(2.6, 7.9);
    CHECK(strip.chosen().onsets == std::vector<std::size_t>{4});
    CHECK(strip.chosen().span == NoteSteps{3, 7});
    strip.box(-0.4, 8.1);
    CHECK(strip.chosen().onsets == std::vector<std::size_t>{0, 4});
    CHECK(strip.at("notes chosen").value == "2 notes");
    const std::size_t patterns = strip.app.work.document.set.vibrations.size();
    strip.press('d', true);
    CHECK(strip.rhythm() == "x=--5---x=--5---");
    CHECK(strip.last_step() == "Double notes of p1");
    CHECK(strip.app.work.document.set.vibrations.size() == patterns);
    CHECK(strip.chosen().onsets == std::vector<std::size_t>{8, 12});
    strip.press_key(key::kEscape);
    CHECK(strip.chosen().empty());
    strip.press('d', true);  // removes the pattern again
    CHECK(strip.app.work.document.set.vibrations.size() == patterns + 1);
}

TEST_CASE("wave strip: chosen notes are copied to where the mouse is, or to the playhead") {
    Notes strip;
    strip.box(-0.4, 7.9);
    strip.press('c', true);
    strip.hover(strip.step(10.5));
    strip.press('v', true);
    CHECK(strip.rhythm() == "x=--5---x=x=--5---");
    CHECK(strip.pattern().duration_s == doctest::Approx(18 * 0.0625));
    strip.press('z', true);
    CHECK(strip.rhythm() == "x=--5---");
    CHECK(strip.pattern().duration_s == doctest::Approx(1.0));
    strip.hover({5.0F, 5.0F});
    strip.app.timeline.playhead.at_s = 3 * 0.0625;
    strip.press('v', true);
    CHECK(strip.rhythm() == "x=-x=--5----5---");
    // Another tool: the clipboard is not a pattern, and nothing is pasted.
    strip.press('c', false);
    const std::string before = strip.rhythm();
    strip.press('v', true);
    CHECK(strip.rhythm() == before);
}

TEST_CASE("wave strip: chosen notes move by steps and by beats, and are removed, one step each") {
    Notes strip;
    strip.box(-0.4, 7.9);
    strip.press_key(key::kRight);
    CHECK(strip.rhythm() == "-x=--5--");
    CHECK(strip.last_step() == "Change notes of p1");
    strip.press_key(key::kLeft);
    CHECK(strip.rhythm() == "x=--5---");
    strip.drag(strip.step(4.4), strip.step(6.4), 6);
    CHECK(strip.rhythm() == "--x=--5-");
    undo(strip.app.ui, strip.app.work);
    strip.settle();
    strip.pattern().rhythm.text = "--5-------------";
    document_changed(strip.app.work);
    strip.settle();
    strip.window.move(strip.step(2.4));
    strip.window.button(true);
    strip.settle();
    strip.shift(true);
    strip.hover(strip.step(5.1));
    CHECK(strip.rhythm() == "----5-----------");
    strip.shift(false);
    strip.window.button(false);
    strip.settle();
}

TEST_CASE("wave strip: the top of one chosen note makes all stronger by as much") {
    Notes strip;
    strip.box(-0.4, 7.9);
    const Place first = strip.at("note:0");
    const float ninth = (first.max.y - first.min.y) / 9.0F;
    const float x = first.middle().x;
    strip.drag({x, first.min.y}, {x, first.min.y + 3.0F * ninth}, 6);
    CHECK(strip.rhythm() == "6=--2---");
    CHECK(strip.last_step() == "Change notes of p1");
    strip.press_key(key::kDelete);
    CHECK(strip.rhythm() == "--------");
    CHECK(strip.last_step() == "Remove notes of p1");
    CHECK(strip.app.work.document.set.vibrations.size() == 2);
}

TEST_CASE("wave strip: notes are chosen by keys, and one more by Shift and a click") {
    Notes strip;
    strip.press(U'n');
    CHECK(strip.chosen().onsets == std::vector<std::size_t>{0});
    strip.press(U'n');
    CHECK(strip.chosen().onsets == std::vector<std::size_t>{4});
    strip.shift(true);
    strip.click_at(strip.step(1.0));
    strip.shift(false);
    CHECK(strip.chosen().onsets == std::vector<std::size_t>{0, 4});
    strip.press('a', true);
    CHECK(strip.chosen().onsets.size() == 4);  // with the text's repetition
    strip.click_at(strip.step(4.4));
    CHECK(strip.chosen().onsets == std::vector<std::size_t>{4});
    strip.click("entry:chosen_strength");
    strip.type("100");
    strip.press_key(key::kEnter);
    CHECK(strip.rhythm() == "x=--x---");
    strip.click("entry:chosen_length_ms");
    strip.type("130");
    strip.press_key(key::kEnter);
    CHECK(strip.rhythm() == "x=--x=--");
    // A strength between two ninths, with a pitch, needs a kind of its own.
    strip.click("entry:chosen_strength");
    strip.type("37");
    strip.press_key(key::kEnter);
    CHECK(strip.rhythm() == "x=--A=--");
    strip.click("entry:chosen_pitch");
    strip.type("1.5");
    strip.press_key(key::kEnter);
    CHECK(strip.rhythm() == "x=--A=--");
    const Pattern& pattern = *shown_pattern(strip.app.work);
    CHECK(kind_of(pattern.rhythm, 'A').velocity == doctest::Approx(0.37));
    CHECK(kind_of(pattern.rhythm, 'A').pitch == doctest::Approx(1.5));
    CHECK(pattern.rhythm.kinds.size() == 1);
}

TEST_CASE("wave strip: its time is the one of all views, moved, fitted and begun again") {
    Notes strip;
    const auto range = [&] { return strip.app.timeline.range; };
    const auto wheel = [&](float x, float y) {
        push(strip.window.input, {strip.window.now_s, MouseWheel{x, y}});
        strip.settle();
    };
    strip.hover(strip.step(8.0));
    wheel(0.0F, 4.0F);
    const TimeRange zoomed_in = range();
    REQUIRE(zoomed_in.length_s() > 0.0);
    CHECK(zoomed_in.length_s() < 0.6);
    CHECK(zoomed_in.start_s < 0.5);
    CHECK(zoomed_in.end_s > 0.5);
    strip.shift(true);
    wheel(0.0F, -1.0F);
    strip.shift(false);
    CHECK(range().start_s > zoomed_in.start_s);
    CHECK(range().length_s() == doctest::Approx(zoomed_in.length_s()));
    strip.press('0', false);
    CHECK(range().length_s() == 0.0);
    wheel(0.0F, 4.0F);
    const ImVec2 ruler = strip.at("strip:ruler").middle();
    strip.drag(ruler, ruler + ImVec2{40.0F, 0.0F}, 3);
    CHECK(strip.app.timeline.playhead.at_s > range().start_s);
    CHECK(strip.app.timeline.playhead.at_s < range().end_s);
    for (int k = 0; k < 60; ++k) strip.frame();  // a second double click
    strip.click_at(ruler);
    strip.click_at(ruler);
    CHECK(range().length_s() == 0.0);
    strip.hover(strip.step(8.0));
    wheel(0.0F, 4.0F);
    REQUIRE(range().length_s() > 0.0);
    strip.app.work.document.open({short_patterns(2), {}, short_patterns(2)});
    ++strip.app.work.document_number;
    strip.settle();
    CHECK(range().length_s() == 0.0);
}

TEST_CASE("wave strip: what measures the pattern lies beneath it, and says its name") {
    Strip strip;
    CHECK(!strip.shows("strip:ghost"));
    const Waveform wave = render(strip.pattern());
    Vibration twin;
    twin.name = "p1 measured";
    twin.source = Measurement{std::make_shared<const Waveform>(wave), {}, 1.0, "p1"};
    insert_twin(strip.app.work.document.edit(), twin);
    document_changed(strip.app.work);
    commit_step(strip.app.ui, strip.app.work, "Import");
    select_only(strip.app.work, 0);
    strip.settle();
    CHECK(strip.at("strip:ghost").value.starts_with("beneath: p1 measured"));
}

TEST_CASE("wave strip: with the tool of ticks every press puts one, and a drag moves it") {
    Band strip;
    strip.press('k', false);
    strip.click_at(strip.in_lane(0.2F, 0.5F));
    strip.click_at(strip.in_lane(0.5F, 0.5F));
    REQUIRE(strip.pattern().transients.size() == 2);
    CHECK(strip.last_step() == "Add transient of p1");
    CHECK(strip.pattern().amplitude_curve.empty());
    CHECK(strip.shows("entry:chosen_hz"));
    const double before_s = strip.pattern().transients[1].time_s;
    strip.drag(strip.at("grip:transient:1").middle(), strip.in_lane(0.7F, 0.5F), 6);
    REQUIRE(strip.pattern().transients.size() == 2);
    CHECK(strip.pattern().transients[1].time_s > before_s + 0.1 * strip.pattern().duration_s);
}

}  // namespace wave_strip_test
