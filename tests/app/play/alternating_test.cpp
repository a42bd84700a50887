// A|B names its two patterns, and swaps them; digits play the picked patterns.
#include <doctest/doctest.h>

#include <memory>
#include <utility>
#include <vector>

#include "app/document/editing.h"
#include "app/subset/subset.h"
#include "tests/support/felt_program.h"
#include "tests/support/patience.h"

namespace alternating_test {

using namespace tact;

namespace {

// Behaves as an output: the next pattern may wait for the end of the present one.
struct QueueingDevice final : Device {
    bool plays = false;
    bool has_ended = false;  // told in one status only
    int begun = 0;
    int stops = 0;
    std::vector<double> rests_s;

    void end() { has_ended = true; }
    Expected<Done> play(const Drive& /*drive*/, bool /*loop*/) override {
        plays = true;
        has_ended = false;
        ++begun;
        return Done{};
    }
    Expected<Done> play_after(const Drive& /*drive*/, double rest_s) override {
        rests_s.push_back(rest_s);
        return Done{};
    }
    void change(const Drive& /*drive*/) override {}
    void set_level(double /*level*/) override {}
    void stop() override {
        plays = false;
        ++stops;
    }
    DeviceStatus status() override {
        const bool ends = std::exchange(has_ended, false);
        DeviceStatus status;
        status.name = "queue";
        status.connected = true;
        status.playing = plays && !ends;
        return status;
    }
};

}  // namespace

TEST_CASE("A|B: the bar names both, and X swaps them") {
    FeltProgram program;
    program.app.work.selection.pinned = "p3";
    program.settle();
    CHECK(program.at("alternate:pair").value == "A p1 | B p3");
    program.press('x');
    CHECK(program.at("alternate:pair").value == "A p3 | B p1");
    CHECK(program.app.work.selection.current == 2);
    program.press('x');
    CHECK(program.at("alternate:pair").value == "A p1 | B p3");
    CHECK(program.app.work.document.history.undo_label() == nullptr);
}

TEST_CASE("A|B: a swap while they sound changes their letters, not what is felt") {
    FeltProgram program;
    program.app.work.selection.pinned = "p3";
    program.app.timeline.playhead.loop = true;
    program.click("transport:A|B");
    program.space();
    REQUIRE(program.plays(0));
    program.press('x');
    CHECK(program.plays(0));
    CHECK(program.at("alternate:pair").value == "A p3 | B p1");
    program.device->end();
    program.wait(0.7);
    CHECK(program.plays(2));
    program.device->end();
    program.wait(0.7);
    CHECK(program.plays(0));
    CHECK(program.device->begun() == 3);
}

TEST_CASE("A|B: a device that can keeps the pause, and is given the next one while one sounds") {
    FeltProgram program;
    const auto queue = std::make_shared<QueueingDevice>();
    program.app.play.device = queue;
    program.app.play.gap_s = 0.3;
    program.app.work.selection.pinned = "p3";
    program.app.timeline.playhead.loop = true;
    program.click("transport:A|B");
    program.space();
    CHECK(queue->begun == 1);
    REQUIRE(queue->rests_s == std::vector<double>{0.3});
    // The device continues with the next pattern by itself: no call starts it, and the third waits
    // for it.
    queue->end();
    program.settle();
    CHECK(program.app.play.sounding->at == 1);
    CHECK(queue->begun == 1);
    CHECK(queue->rests_s == std::vector<double>{0.3, 0.3});
    // Edited while it waits: the device does not play the old version.
    edit_patterns(program.app.work, [](Pattern& pattern) { pattern.amplitude_g *= 0.5; });
    program.settle();
    queue->end();
    program.frame();
    CHECK(queue->stops > 0);
    program.wait(0.5);
    CHECK(queue->begun == 2);
}

TEST_CASE("A|B: a pattern alone has no partner to be named") {
    FeltProgram program(1);
    CHECK(program.shows("transport:A|B"));
    CHECK_FALSE(program.shows("alternate:pair"));
    program.press('x');
    CHECK(program.app.work.selection.current == 0);
}

TEST_CASE("A|B: names give way where the bar is narrow, the letters stay") {
    FeltProgram program;
    const auto width = [&] {
        const Place& place = program.at("transport:A|B");
        return place.max.x - place.min.x;
    };
    const float wide = width();
    program.resize({800.0F, 700.0F}, 1.0F);
    REQUIRE(program.shows("transport:A|B"));
    CHECK(width() < 0.6F * wide);
}

TEST_CASE("keys: 1 to 9 play what was picked, by its number in the list") {
    FeltProgram program(6);
    App& app = program.app;
    program.press('2');
    CHECK_FALSE(program.device->playing());
    CHECK(app.ui.status.text.starts_with("Nothing is picked yet"));
    app.layout.bench = BenchTab::subset;
    app.picking.count = 3;
    program.compute_map();
    const auto until = end_of_patience();
    while (shown_subset(app.shown_map, app.picking) == nullptr) {
        REQUIRE(std::chrono::steady_clock::now() < until);
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
        program.frame();
    }
    program.settle();
    const std::vector<std::size_t> members = shown_subset(app.shown_map, app.picking)->members;
    REQUIRE(members.size() == 3);
    for (std::size_t k = 0; k < 3; ++k) {
        program.press(static_cast<char32_t>('1' + k));
        CHECK(program.plays(members[k]));
        CHECK_FALSE(program.device->looping());
    }
    program.press('4');
    CHECK(app.ui.status.text == "Only 3 are picked.");
    // Typed into a field, they are a number.
    const int begun = program.device->begun();
    program.click("entry:amplitude_g");
    program.type("1");
    CHECK(program.device->begun() == begun);
}

TEST_CASE("keys: columns are arranged by Ctrl and a digit, not by the digit alone") {
    Program program(short_patterns(2));
    const float before = program.app.layout.right;
    program.press('3');
    CHECK(program.app.layout.right == before);
    program.press('3', true);
    CHECK(program.app.layout.right != before);
    program.press('1', true);
    CHECK(program.app.layout.right == before);
}

}  // namespace alternating_test
