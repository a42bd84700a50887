// Playback in the program's real frames, with a device that records its drives.

#include "app/play/play.h"

#include <doctest/doctest.h>

#include "tests/support/felt_program.h"
#include "tests/support/patience.h"
#include "tests/support/program.h"

namespace playing_test {

using namespace tact;

TEST_CASE("playing: Space sends the current pattern to the device, at a low level, and stops it") {
    FeltProgram program;
    program.space();
    REQUIRE(program.plays(0));
    CHECK(program.device->level() == 0.1);
    CHECK_FALSE(program.device->looping());
    CHECK(program.app.timeline.playhead.playing);
    program.space();
    CHECK_FALSE(program.device->playing());
    CHECK_FALSE(program.app.timeline.playhead.playing);
}

TEST_CASE("playing: the playhead is where the device says that it is felt, and ends with it") {
    FeltProgram program;
    program.space();
    program.device->pretend(0.042, 0.0, false);
    program.frame();
    CHECK(program.app.timeline.playhead.at_s == 0.042);
    program.device->end();
    program.frame();
    CHECK_FALSE(program.app.timeline.playhead.playing);
    CHECK_FALSE(is_sounding(program.app.play));
}

TEST_CASE("playing: slow motion is silent, and slowing down silences") {
    FeltProgram program;
    program.click("speed:1/10");
    program.space();
    CHECK_FALSE(program.device->playing());
    CHECK(program.app.timeline.playhead.playing);
    program.click("speed:1\u00d7");  // it is running: from now on it is felt
    CHECK(program.plays(0));
    program.click("speed:1/100");
    CHECK_FALSE(program.device->playing());
    CHECK(program.app.timeline.playhead.playing);
}

TEST_CASE("playing: Esc silences in the frame it is pressed in, and does nothing else there") {
    FeltProgram program;
    program.app.layout.maximised = Pane::physiology;
    program.space();
    REQUIRE(program.plays(0));
    program.window.press(key::kEscape);
    program.frame();
    CHECK_FALSE(program.device->playing());
    program.settle();
    CHECK(program.app.layout.maximised == Pane::physiology);
    program.press_key(key::kEscape);  // now it has its usual meaning
    CHECK_FALSE(program.app.layout.maximised);
}

TEST_CASE("playing: Esc silences also in a dialog") {
    FeltProgram program;
    program.app.ui.dialog = kDevicesDialog;
    program.settle();
    program.click("button:test buzz");
    REQUIRE(program.device->playing());
    CHECK(*program.device->playing() == test_buzz());
    program.window.press(key::kEscape);
    program.frame();
    CHECK_FALSE(program.device->playing());
}

TEST_CASE("playing: a loop becomes what is edited in the same frame, and does not start again") {
    FeltProgram program;
    program.app.timeline.playhead.loop = true;
    program.space();
    REQUIRE(program.device->looping());
    program.device->pretend(0.05, 0.1, false);
    program.frame();
    edit_patterns(program.app.work, [](Pattern& pattern) { pattern.amplitude_g = 0.3; });
    program.frame();
    CHECK(program.plays(0));
    CHECK(program.device->begun() == 1);
    CHECK(program.device->looping());
    undo(program.app.ui, program.app.work);
    edit_patterns(program.app.work, [](Pattern& pattern) { pattern.duration_s = 0.08; });
    program.frame();
    CHECK(program.plays(0));
    CHECK(program.device->begun() == 1);
}

TEST_CASE("playing: a loop takes up another pattern at its next round, not in the middle") {
    FeltProgram program;
    program.app.timeline.playhead.loop = true;
    program.space();
    program.device->pretend(0.05, 0.1, false);
    program.frame();
    select_only(program.app.work, 1);
    program.device->pretend(0.08, 0.1, false);
    program.frame();
    CHECK(program.plays(0));
    program.device->pretend(0.01, 0.1, false);
    program.frame();
    CHECK(program.plays(1));
    CHECK(program.device->begun() == 2);
    edit_patterns(program.app.work, [](Pattern& pattern) { pattern.amplitude_g = 0.3; });
    program.frame();
    CHECK(program.plays(1));
    CHECK(program.device->begun() == 2);
}

TEST_CASE("playing: a long pattern is rendered beside the window, and its edits are heard, too") {
    FeltProgram program;
    edit_patterns(program.app.work, [](Pattern& pattern) { pattern.duration_s = 3.0; });
    program.app.timeline.playhead.loop = true;
    program.space();
    const auto comes = [&] {
        const auto until = end_of_patience();
        while (!program.plays(0) && std::chrono::steady_clock::now() < until) program.frame();
        return program.plays(0);
    };
    CHECK(comes());
    for (const double amplitude_g : {0.2, 0.3, 0.4}) {
        edit_patterns(program.app.work, [&](Pattern& p) { p.amplitude_g = amplitude_g; });
        program.frame();
    }
    CHECK(comes());
    CHECK(program.device->begun() == 1);
    CHECK(program.app.play.sounding->is_prepared);
}

TEST_CASE("playing: an output that had gaps is rendered farther ahead, twice as far each time") {
    FeltProgram program;
    PlayState& play = program.app.play;
    program.app.timeline.playhead.loop = true;
    for (const double ahead_s : {0.02, 0.04, 0.08, 0.1, 0.1}) {
        CHECK(play.live_buffer_s == doctest::Approx(ahead_s));
        play.opened.buffer_s = play.live_buffer_s;  // as it would be opened
        program.app.ui.status = {};
        program.space();
        program.device->drop_out();
        program.frame();
        program.frame();
        CHECK(program.app.ui.status.text.starts_with("The sound had gaps") == (ahead_s < 0.1));
        CHECK(program.device->playing());
        program.space();
    }
    // A measurement is rendered far ahead anyway.
    play.live_buffer_s = play.opened.buffer_s = 0.02;
    program.app.ui.dialog = kCalibrateDialog;
    program.frame();
    play_test_buzz(program.app.ui, program.app.timeline, play);
    program.frame();
    CHECK(play.live_buffer_s == 0.02);
}

TEST_CASE("playing: A|B plays the pattern and its partner in turn, with a gap") {
    FeltProgram program;
    program.app.work.selection.pinned = "p3";
    program.app.timeline.playhead.loop = true;
    program.click("transport:A|B");
    program.space();
    REQUIRE(program.plays(0));
    CHECK_FALSE(program.device->looping());
    program.device->end();
    program.frame();
    program.frame();
    CHECK(program.device->rests_s().front() == 0.5);  // the device keeps the rest
    program.wait(0.6);
    CHECK(program.plays(2));
    program.device->end();
    program.wait(0.6);
    CHECK(program.plays(0));
    program.press_key(key::kEscape);
    program.wait(1.0);
    CHECK_FALSE(program.device->playing());
}

TEST_CASE("playing: all in sequence, each once, each shown while it is felt") {
    FeltProgram program;
    play_all(program.app.ui, program.app.work, program.app.timeline, program.app.play);
    for (const std::size_t index : {0U, 1U, 2U}) {
        program.frame();
        REQUIRE(program.plays(index));
        CHECK(program.app.work.selection.current == index);
        program.device->end();
        program.wait(0.6);
    }
    CHECK_FALSE(is_sounding(program.app.play));
    CHECK_FALSE(program.device->playing());
}

TEST_CASE("playing: the clip light stays on until it is clicked, the meter falls by itself") {
    FeltProgram program;
    program.space();
    program.device->pretend(0.01, 0.8, true);
    program.frame();
    CHECK(program.app.play.clip_light);
    CHECK(program.app.play.meter == 0.8);
    program.device->pretend(0.02, 0.0, false);
    program.space();
    program.wait(2.5);
    CHECK(program.app.play.clip_light);
    CHECK(program.app.play.meter == 0.0);
    program.click("clip");
    CHECK_FALSE(program.app.play.clip_light);
}

TEST_CASE("playing: the level is felt while it plays") {
    FeltProgram program;
    program.space();
    const Place slider = program.at("slider:level_percent");
    program.window.move({slider.max.x - 2.0F, slider.middle().y});
    program.window.button(true);
    program.settle();
    CHECK(program.device->level() > 0.9);
    program.window.button(false);
    program.settle();
    CHECK(program.plays(0));
}

TEST_CASE("playing: in the map a double click plays, and so does resting on a point, if wanted") {
    FeltProgram program;
    program.compute_map();
    program.wait(1.0);
    const ImVec2 point = program.at("point:p2").middle();
    program.hover(point);
    program.wait(0.5);
    CHECK_FALSE(program.device->playing());
    program.app.play.on_hover = true;
    program.wait(0.5);
    REQUIRE(program.plays(1));
    program.device->end();
    program.wait(1.0);
    CHECK_FALSE(program.device->playing());  // once
    program.app.play.on_hover = false;
    program.window.click(point);
    program.window.click(point);
    program.settle();
    CHECK(program.plays(1));
}

TEST_CASE("playing: Esc that comes before its frame stops the device, and no sequence goes on") {
    FeltProgram program;
    program.app.play.gap_s = 0.0;
    play_all(program.app.ui, program.app.work, program.app.timeline, program.app.play);
    program.frame();
    REQUIRE(program.plays(0));
    EmergencyStop stop;
    stop.watch(program.app.play.device);
    stop.stop();  // as the window does when the key is pressed
    CHECK_FALSE(program.device->playing());
    program.app.play.halted = stop.take();
    CHECK(program.app.play.halted);
    CHECK_FALSE(stop.take());
    for (int k = 0; k < 5; ++k) program.frame();
    CHECK_FALSE(program.device->playing());
    program.app.work.selection.others = {1};
    program.press_key(key::kEscape);
    CHECK_FALSE(is_sounding(program.app.play));
    CHECK(program.app.work.selection.others.size() == 1);  // enough for this test
    program.space();
    CHECK(program.device->playing());
}

TEST_CASE("playing: a calibrated drive is computed beside the frames, and then played") {
    FeltProgram program;
    Calibration flat;
    flat.points = {{20.0, 2.0}, {500.0, 2.0}};
    program.app.play.calibration = std::make_shared<const Calibration>(flat);
    const Vibration& first = program.app.work.document.set.vibrations[0];
    const Drive wanted = calibrated_drive(waveform_of(first), flat).drive;
    program.window.press(key::kSpace, U' ');
    const auto until = end_of_patience();
    while (!program.device->playing()) {
        REQUIRE(std::chrono::steady_clock::now() < until);
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
        program.frame();
    }
    CHECK(*program.device->playing() == wanted);
    CHECK(is_sounding(program.app.play));
    program.settle();
    program.space();
    CHECK_FALSE(program.device->playing());
    CHECK_FALSE(is_sounding(program.app.play));
}

TEST_CASE("playing: what was being computed when it was silenced is not played") {
    FeltProgram program;
    Calibration flat;
    flat.points = {{20.0, 2.0}, {500.0, 2.0}};
    program.app.play.calibration = std::make_shared<const Calibration>(flat);
    play_once(program.app.ui, program.app.work, program.app.timeline, program.app.play, 0);
    silence(program.app.timeline, program.app.play);
    const auto until = end_of_patience();
    while (!program.app.play.drive_job.latest()) {
        REQUIRE(std::chrono::steady_clock::now() < until);
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    program.settle();
    CHECK_FALSE(program.device->playing());
}

TEST_CASE("playing: protection that is switched holds for what sounds, in the same frame") {
    FeltProgram program;
    program.app.timeline.playhead.loop = true;
    program.app.play.is_protected = false;
    program.space();
    REQUIRE(*program.device->playing() == program.drive_of_pattern(0));
    const int begun = program.device->begun();
    program.app.play.is_protected = true;
    program.frame();
    CHECK(program.plays(0));
    CHECK(program.device->begun() == begun);  // the loop continues
    program.app.play.is_protected = false;
    program.frame();
    CHECK(*program.device->playing() == program.drive_of_pattern(0));
    // The same holds for full scale.
    program.app.play.full_scale_g = 2.0;
    program.frame();
    CHECK(program.device->playing()->samples[100] ==
          program.drive_of_pattern(0).samples[100] / 2.0);
    program.space();
    // A single pass cannot change its drive: it ends.
    program.app.timeline.playhead.loop = false;
    program.space();
    REQUIRE(program.device->playing());
    program.app.play.is_protected = true;
    program.frame();
    CHECK_FALSE(program.device->playing());
    CHECK(program.app.ui.status.text.find("was not protected") != std::string::npos);
}

}  // namespace playing_test
