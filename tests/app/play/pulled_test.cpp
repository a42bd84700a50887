// The device is unplugged in any state: one sentence, silence, and it works again once it is back.
#include <doctest/doctest.h>

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "app/document/editing.h"
#include "app/play/play.h"
#include "tests/support/felt_program.h"
#include "tests/support/patience.h"

namespace pulled_test {

using namespace tact;

namespace {

constexpr const char* kGone = "the coil is gone: plug it in to go on";

// Behaves as real devices: playing ends, a play is refused, and the status says so at rest, too.
struct PulledDevice final : Device {
    bool is_gone = false;
    bool plays = false;
    int begun = 0;

    Expected<Done> play(const Drive& /*drive*/, bool /*loop*/) override {
        if (is_gone) return Error{kGone};
        plays = true;
        ++begun;
        return Done{};
    }
    Expected<Done> play_after(const Drive& drive, double /*rest_s*/) override {
        return play(drive, false);
    }
    void change(const Drive& /*drive*/) override {}
    void set_level(double /*level*/) override {}
    void stop() override { plays = false; }
    DeviceStatus status() override {
        if (is_gone) plays = false;
        return {.name = "coil",
                .connected = !is_gone,
                .playing = plays,
                .position_s = plays ? 0.1 : 0.0,
                .trouble = is_gone ? kGone : ""};
    }
};

struct Pulled : FeltProgram {
    std::shared_ptr<PulledDevice> coil = std::make_shared<PulledDevice>();

    Pulled() {
        app.play.device = coil;
        settle();
    }
    void loop() { app.timeline.playhead.loop = true; }
    void edit(double duration_s) {
        edit_patterns(app.work, [&](Pattern& pattern) {
            pattern.amplitude_g *= 0.5;
            pattern.duration_s = duration_s;
        });
    }
    void alternate() {
        app.work.selection.pinned = "p3";
        loop();
        click("transport:A|B");
        space();
    }
    void come_to_the_end() {  // of the first pattern; the rest begins
        coil->plays = false;
        frame();
        frame();
    }
    void wait_for_drives() {
        const auto until = end_of_patience();
        while (app.play.drive_job.busy()) {
            REQUIRE(std::chrono::steady_clock::now() < until);
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        }
        settle();
    }
};

constexpr double kLongS = 3.0;  // rendered in the background

struct State {
    const char* name;
    std::function<void(Pulled&)> begin;
};

const std::vector<State>& states() {
    static const std::vector<State> all{
        {"at rest", [](Pulled&) {}},
        {"a pattern", [](Pulled& program) { program.space(); }},
        {"a loop",
         [](Pulled& program) {
             program.loop();
             program.space();
         }},
        {"a loop that was edited since the last frame",
         [](Pulled& program) {
             program.loop();
             program.space();
             program.edit(0.1);
         }},
        {"a pattern that is being rendered",
         [](Pulled& program) {
             program.edit(kLongS);
             program.space();
         }},
        {"a loop whose edit is being rendered",
         [](Pulled& program) {
             program.edit(kLongS);
             program.loop();
             program.space();
             program.wait_for_drives();
             program.edit(kLongS);
             program.frame();
         }},
        {"A|B", [](Pulled& program) { program.alternate(); }},
        {"the rest between A and B",
         [](Pulled& program) {
             program.alternate();
             program.come_to_the_end();
         }},
        {"all in sequence",
         [](Pulled& program) {
             play_all(program.app.ui, program.app.work, program.app.timeline, program.app.play);
         }},
        {"the rest between two in sequence",
         [](Pulled& program) {
             play_all(program.app.ui, program.app.work, program.app.timeline, program.app.play);
             program.frame();
             program.come_to_the_end();
         }},
        {"a row that is held",
         [](Pulled& program) {
             program.window.move(program.at("row:p2").middle());
             program.window.button(true);
             program.settle();
             program.wait(kHoldS + 0.05);
         }},
        {"the test buzz",
         [](Pulled& program) {
             play_test_buzz(program.app.ui, program.app.timeline, program.app.play);
         }},
        {"a signal that measures the actuator",
         [](Pulled& program) {
             play_signal(program.app.ui, program.app.timeline, program.app.play, test_buzz(), 0.5);
         }},
        {"slow motion, which is silent", [](Pulled& program) {
             program.click("speed:1/10");
             program.space();
         }}};
    return all;
}

void let_all_go(Pulled& program) {
    program.window.button(false);
    program.settle();
    stop_playing(program.app.timeline, program.app.play);
    program.app.timeline.playhead.speed = 1.0;
    program.app.ui.status = {};
}

// Another attempt while it is unplugged gives the sentence again; once it is back, it plays.
void check_that_it_can_come_back(Pulled& program) {
    let_all_go(program);
    program.space();
    program.wait_for_drives();
    CHECK_FALSE(is_sounding(program.app.play));
    CHECK(program.app.ui.status.text == kGone);
    let_all_go(program);
    program.coil->is_gone = false;
    program.settle();
    CHECK(device_trouble(program.app.play).empty());
    program.space();
    program.wait_for_drives();
    CHECK(program.coil->plays);
    CHECK(is_sounding(program.app.play));
}

}  // namespace

TEST_CASE("pulled: in every state of playing it is said once, and nothing plays on" *
          doctest::test_suite("long")) {
    for (const State& state : states()) {
        CAPTURE(std::string(state.name));
        Pulled program;
        state.begin(program);
        program.app.ui.status = {};
        program.coil->is_gone = true;
        program.settle();
        program.wait_for_drives();
        CHECK_FALSE(is_sounding(program.app.play));
        CHECK(program.app.ui.status.is_error);
        CHECK(program.app.ui.status.text == kGone);
        program.app.ui.status = {};
        const int begun = program.coil->begun;
        program.wait(1.0);  // longer than any rest
        CHECK(program.app.ui.status.text != kGone);
        CHECK(device_trouble(program.app.play) == kGone);
        CHECK(program.coil->begun == begun);
        check_that_it_can_come_back(program);
    }
}

TEST_CASE("pulled: one that goes before a play is begun refuses it, in every state" *
          doctest::test_suite("long")) {
    for (const State& state : states()) {
        CAPTURE(std::string(state.name));
        Pulled program;
        program.coil->is_gone = true;
        program.settle();
        state.begin(program);
        program.settle();
        program.wait_for_drives();
        CHECK_FALSE(is_sounding(program.app.play));
        CHECK(program.coil->begun == 0);
        CHECK(device_trouble(program.app.play) == kGone);
        check_that_it_can_come_back(program);
    }
}

TEST_CASE("pulled: in the very frame in which it goes, an edit and a swap of A|B do no harm") {
    for (const bool swaps : {false, true}) {
        Pulled program;
        program.loop();
        swaps ? program.alternate() : program.space();
        program.coil->is_gone = true;
        swaps ? program.press('x') : program.edit(0.1);
        program.settle();
        CHECK_FALSE(is_sounding(program.app.play));
        CHECK(program.app.ui.status.text == kGone);
    }
}

TEST_CASE("pulled: the level starts at 10 % again, said; the complaint goes with what is felt") {
    Pulled program;
    PlayState& play = program.app.play;
    const StatusLine& line = program.app.ui.status;
    play.level = 0.9;
    program.space();
    program.coil->is_gone = true;
    program.settle();
    CHECK(play.level == kFirstLevel);
    CHECK(line.is_error);
    CHECK(line.text == std::string(kGone) + ". The level starts at 10 % again.");
    // Once it is back, the sentence stays red until a pattern plays.
    program.coil->is_gone = false;
    program.settle();
    CHECK(line.is_error);
    program.space();
    program.settle();
    CHECK(program.coil->plays);
    CHECK(line.text.empty());
    CHECK(play.level == kFirstLevel);
}

TEST_CASE("pulled: one that is listed no more, and comes back, is felt softly") {
    Pulled program;
    PlayState& play = program.app.play;
    play.level = 0.9;
    const auto listed = std::exchange(play.listed, std::make_shared<const Listing>());
    program.settle();
    CHECK(play.level == kFirstLevel);
    CHECK(program.app.ui.status.text == "The level starts at 10 % again.");
    play.listed = listed;
    program.settle();
    CHECK(play.level == kFirstLevel);
}

}  // namespace pulled_test
