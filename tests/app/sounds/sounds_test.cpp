// From sound...: any sound beside what would be felt of it, and into the set.
#include <doctest/doctest.h>

#include <cmath>

#include "app/document/editing.h"
#include "app/sounds/sounds.h"
#include "app/window/window.h"
#include "model/io/recordings/wave_file.h"
#include "tests/support/program.h"
#include "tests/support/scene_steps.h"
#include "tests/support/temporary_folder.h"

namespace sounds_test {

using namespace tact;

namespace {

Pattern notes() {
    Pattern pattern;
    pattern.amplitude_g = 0.8;
    pattern.carriers[0].frequency_hz = 180.0;
    pattern.rhythm = {"x=-x=---", 0.1};
    pattern.duration_s = 0.8;
    return pattern;
}

std::filesystem::path sound_of(const TemporaryFolder& folder, const char* name,
                               const Pattern& pattern) {
    const auto path = folder.path / name;
    REQUIRE(write_wave_file(path, render(pattern)));
    return path;
}

void open(Program& program, const std::vector<std::filesystem::path>& files) {
    open_sounds(program.app.ui, program.app.work, program.app.sounds, files);
    wait_until(program, [&] { return current_sounds(program.app.sounds) != nullptr; });
    program.settle();
}

std::size_t count(const Program& program) {
    return program.app.work.document.set.vibrations.size();
}

}  // namespace

TEST_CASE("from sound: a sound is looked at, becomes a pattern, and undo takes it back") {
    const TemporaryFolder folder;
    Program program(short_patterns(2));
    App& app = program.app;
    open(program, {sound_of(folder, "notes.wav", notes())});
    CHECK(program.shows("sounds:preview"));
    CHECK(count(program) == 2);
    wait_until(program, [&] { return current_sounds(app.sounds)->request.with_pm; });
    program.settle();
    CHECK(program.at("sounds:remarks").value.find("PM") != std::string::npos);
    program.click("button:choose");
    CHECK(app.ui.dialog == kNoDialog);
    REQUIRE(count(program) == 3);
    const Vibration* added = current_vibration(app.work);
    REQUIRE(added != nullptr);
    CHECK(added->name == "notes");
    CHECK(added->note.find("From the sound notes.wav, for core-haptics") == 0);
    CHECK(std::abs(envelope_g(std::get<Pattern>(added->source), 0.1) - 0.8) <= 0.04);
    undo(app.ui, app.work);
    CHECK(count(program) == 2);
}

TEST_CASE("from sound: another actuator, or none of the onsets, is another pattern at once") {
    const TemporaryFolder folder;
    Program program(short_patterns(2));
    App& app = program.app;
    Pattern both = notes();
    both.transients = {{0.62, 0.7, 120.0, 0.03}};
    open(program, {sound_of(folder, "both.wav", both)});
    const auto made = [&]() -> const SoundPattern& {
        return current_sounds(app.sounds)->sounds.front().sound->made;
    };
    CHECK(made().pattern.transients.size() == 1);
    program.click("sounds:accents");
    wait_until(program, [&] { return current_sounds(app.sounds) != nullptr; });
    CHECK(made().pattern.transients.empty());
    const double share_outside = made().outside_share;
    program.click("sounds:actuator");
    program.click("sounds actuator:quest");
    wait_until(program, [&] { return current_sounds(app.sounds) != nullptr; });
    CHECK(app.sounds.wanted.actuator == "quest");
    CHECK(made().outside_share != share_outside);
}

TEST_CASE("from sound: what cannot be read is left out, said, and nothing is lost") {
    const TemporaryFolder folder;
    Program program(short_patterns(2));
    App& app = program.app;
    const auto good = sound_of(folder, "good.wav", notes());
    const auto bad = folder.write("bad.wav", "no sound at all");
    open(program, {bad});
    program.click("button:choose");
    CHECK(app.ui.dialog == kSoundsDialog);
    CHECK(count(program) == 2);
    program.click("button:cancel");
    CHECK(app.ui.dialog == kNoDialog);
    open(program, {bad, good});
    program.click("button:choose");
    CHECK(count(program) == 3);
    CHECK(app.ui.status.text.find("1 file was left out") != std::string::npos);
}

TEST_CASE("from sound: a sound that is dropped opens it, a WAV file stays what it is") {
    const TemporaryFolder folder;
    const auto wave = sound_of(folder, "a.wav", notes());
    CHECK_FALSE(are_sounds({wave}));
    const auto other = folder.path / "a.flac";
    std::filesystem::copy(wave, other);
    CHECK(are_sounds({other}));
    CHECK_FALSE(are_sounds({other, wave}));
    CHECK_FALSE(are_sounds({folder.write("a.ogg", "no sound")}));
    Program program(short_patterns(2));
    drop_paths(program.app, {other});
    CHECK(program.app.ui.dialog == kSoundsDialog);
}

}  // namespace sounds_test
