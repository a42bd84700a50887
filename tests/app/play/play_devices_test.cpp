// The device of playback: chosen, lost, remembered, exchanged.
#include "app/play/play.h"

#include <doctest/doctest.h>

#include "app/play/parts.h"
#include "tests/support/felt_program.h"

namespace play_devices_test {

using namespace tact;

TEST_CASE("playing: a lost device says so once, and nothing plays") {
    FeltProgram program;
    program.space();
    program.device->pretend(0.0, 0.0, false, "memory is gone: nothing plays until it is back");
    program.settle();
    CHECK_FALSE(program.app.timeline.playhead.playing);
    CHECK_FALSE(is_sounding(program.app.play));
    CHECK(program.app.ui.status.is_error);
    CHECK(program.app.ui.status.text == "memory is gone: nothing plays until it is back");
    program.app.ui.status = {};
    program.settle();
    CHECK(program.app.ui.status.text.empty());
    CHECK(device_trouble(program.app.play) == "memory is gone: nothing plays until it is back");
}

TEST_CASE("playing: without a device it says that it plays silently, and has a word of advice") {
    Program program(short_patterns(2));
    program.app.play.listed = std::make_shared<const Listing>();
    program.app.timeline.playhead.speed = 1.0;
    program.settle();
    CHECK(program.at("device").value == "No device");
    CHECK_FALSE(program.shows("level"));
    CHECK_FALSE(program.shows("clip"));
    program.window.press(key::kSpace, U' ');
    program.settle();
    CHECK(program.app.timeline.playhead.playing);
    CHECK(program.app.ui.status.text.starts_with("Plays silently: no actuator is chosen."));
    CHECK_FALSE(program.app.ui.status.is_error);
    program.click("device");
    CHECK(program.at("device advice").value.find("Plug in") == 0);
}

TEST_CASE(
    "playing: by ear a pattern is two octaves up, as strong and as long, and a recording says so") {
    FeltProgram program;
    Vibration tone = program.app.work.document.set.vibrations[0];
    auto& pattern = std::get<Pattern>(tone.source);
    pattern.carriers = {{100.0, 1.0, 0.0}};
    pattern.frequency_curve = {{0.0, 100.0}, {0.1, 50.0}};
    pattern.transients = {{0.02, 0.5, 200.0}};
    const Pattern heard = for_ear(pattern);
    CHECK(heard.carriers[0].frequency_hz == 400.0);
    CHECK(heard.frequency_curve[1].frequency_hz == 200.0);
    CHECK(heard.transients[0].frequency_hz == 800.0);
    CHECK(heard.modulation == pattern.modulation);
    CHECK(heard.duration_s == pattern.duration_s);
    program.app.play.for_ear = true;
    Vibration meant = tone;
    meant.source = heard;
    const MadeDrive made = made_drive(drive_request(program.app.play, tone));
    CHECK(made.drive.samples ==
          protected_drive(drive_of(waveform_of(meant), 1.0), false, true).drive.samples);
    CHECK(made.remark.find("recording") == std::string::npos);
    Vibration recording = tone;
    recording.source =
        Measurement{std::make_shared<const Waveform>(waveform_of(tone)), {}, 1.0, {}};
    CHECK(made_drive(drive_request(program.app.play, recording)).remark.find("unchanged") !=
          std::string::npos);
    CHECK_FALSE(can_be_calibrated(program.app.play));
    // Headphones are not an actuator, and the next device is felt again.
    keep_devices(program.app.work, program.app.play);
    CHECK(program.app.work.session.device.empty());
    // The same output, chosen as an actuator: another meaning, and a low level again.
    program.app.play.choice.everywhere = true;
    program.app.play.level = 1.0;
    const std::string id = program.app.play.choice.id;
    choose_device(program.app.ui, program.app.timeline, program.app.play,
                  remembered_choice(program.app.play, id));
    CHECK_FALSE(program.app.play.for_ear);
    CHECK(program.app.play.choice.id == id);
    CHECK_FALSE(program.app.play.choice.everywhere);
    CHECK(program.app.play.level == kFirstLevel);
}

TEST_CASE("playing: a device that was chosen and is not there is not replaced by another") {
    FeltProgram program;
    DeviceInfo other;
    other.id = "audio/test/other";
    other.name = "other";
    choose_device(program.app.ui, program.app.timeline, program.app.play,
                  remembered_choice(program.app.play, "audio/test/gone"));
    program.app.play.listed = std::make_shared<const Listing>(Listing{other});
    program.settle();
    program.space();
    CHECK_FALSE(is_sounding(program.app.play));
    CHECK(program.app.timeline.playhead.playing);  // silently
    CHECK(program.app.play.choice.id == "audio/test/gone");
    CHECK(program.at("device").value.find("gone") == 0);
    CHECK(program.app.ui.status.text.find("not there") != std::string::npos);
}

TEST_CASE("playing: how each device was used is remembered, in the session too") {
    App app = make_app();
    DeviceChoice pulse{"audio/ALSA/pulse", 2, 4, 0.02};
    choose_device(app.ui, app.timeline, app.play, pulse);
    choose_device(app.ui, app.timeline, app.play, {"audio/JACK/system", 3, 0, 0.0});
    CHECK(remembered_choice(app.play, "audio/ALSA/pulse") == pulse);
    app.play.full_scale_g = 2.5;
    app.play.whole_buffer_s = 0.3;
    keep_devices(app.work, app.play);
    App next = make_app();
    next.work.session = app.work.session;
    restore_devices(next.work, next.play);
    CHECK(next.play.choice.id == "audio/JACK/system");
    CHECK(next.play.choice.channel == 3);
    CHECK(remembered_choice(next.play, "audio/ALSA/pulse") == pulse);
    CHECK(next.play.full_scale_g == 2.5);
    CHECK(next.play.whole_buffer_s == 0.3);
    CHECK(next.play.level == kFirstLevel);  // every start has a low level
}

TEST_CASE("playing: a controller is still when another window has the keys, sound plays on") {
    FeltProgram program;
    program.space();
    follow_focus(program.app.ui, program.app.timeline, program.app.play, true);
    follow_focus(program.app.ui, program.app.timeline, program.app.play, false);
    CHECK(program.device->playing());
    Listing listed = *program.app.play.listed;
    listed[0].kind = DeviceKind::hid;
    program.app.play.listed = std::make_shared<const Listing>(listed);
    follow_focus(program.app.ui, program.app.timeline, program.app.play,
                 false);  // it was lost before
    CHECK(program.device->playing());
    follow_focus(program.app.ui, program.app.timeline, program.app.play, true);
    follow_focus(program.app.ui, program.app.timeline, program.app.play, false);
    CHECK_FALSE(program.device->playing());
    CHECK_FALSE(is_sounding(program.app.play));
}

TEST_CASE("playing: another device, or another of its channels, begins at a low level again") {
    FeltProgram program;
    PlayState& play = program.app.play;
    play.level = 1.0;
    DeviceChoice choice = play.choice;
    choice.latency_offset_s = 0.01;  // it is the same actuator
    choose_device(program.app.ui, program.app.timeline, program.app.play, choice);
    CHECK(play.level == 1.0);
    choice.channel = 2;
    choose_device(program.app.ui, program.app.timeline, program.app.play, choice);
    CHECK(play.level == kFirstLevel);
    play.level = 1.0;
    choice.id = "audio/test/another";
    choose_device(program.app.ui, program.app.timeline, program.app.play, choice);
    CHECK(play.level == kFirstLevel);
    // A lower level is kept.
    play.level = 0.05;
    choice.id = "audio/test/a third";
    choose_device(program.app.ui, program.app.timeline, program.app.play, choice);
    CHECK(play.level == 0.05);
}

TEST_CASE("playing: with another calibration, or none, a level begins at 10 % again") {
    FeltProgram program;
    PlayState& play = program.app.play;
    DeviceChoice choice = play.choice;
    for (const char* file : {"one.json", "two.json", ""}) {
        play.level = 1.0;
        choice.calibration = file;
        choose_device(program.app.ui, program.app.timeline, play, choice);
        CHECK(play.level == kFirstLevel);
    }
}

TEST_CASE("playing: full scale for another acceleration is another level, and begins at 10 %") {
    FeltProgram program;
    program.app.play.level = 0.8;
    program.app.ui.dialog = kDevicesDialog;
    program.settle();
    program.click("entry:full_scale_g");
    program.type("0.2");
    program.press_key(key::kEnter);
    CHECK(program.app.play.full_scale_g == doctest::Approx(0.2));
    CHECK(program.app.play.level == kFirstLevel);
    CHECK(program.app.ui.status.text == "The level starts at 10 % again.");
}

TEST_CASE("playing: the palette finds the level, and puts the keys there") {
    FeltProgram program;
    program.press('p', true);
    program.settle();
    program.type("level");
    REQUIRE(program.shows("palette:Level..."));
    program.click("palette:Level...");
    program.settle();
    REQUIRE(program.shows("typed"));
    program.type("25");
    program.press_key(key::kEnter);
    CHECK(program.app.play.level == doctest::Approx(0.25));
}

TEST_CASE("playing: a name that leads to another output now is another device, at a low level") {
    FeltProgram program;
    PlayState& play = program.app.play;
    program.space();
    REQUIRE(program.device->playing());
    const auto kept = play.device;  // for inspection afterwards
    play.level = 1.0;
    play.opened_place = "server amplifier";
    DeviceInfo info;
    info.id = play.choice.id;
    info.server_output = "headset";
    info.output_name = "Headset";
    info.name = "PulseAudio";
    info.channels = {"left", "right"};
    play.listed = std::make_shared<const Listing>(Listing{info});
    program.settle();
    CHECK_FALSE(is_sounding(play));
    CHECK_FALSE(program.device->playing());
    CHECK(play.level == kFirstLevel);
    CHECK(device_text(play) == "PulseAudio on Headset, 1, left");
}

}  // namespace play_devices_test
