// tactspace from-sound, as a person at a terminal uses it.
#include <doctest/doctest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "model/io/recordings/wave_file.h"
#include "model/io/set/set_file.h"
#include "tests/support/run_program.h"
#include "tests/support/temporary_folder.h"

namespace from_sound_command_test {

using namespace tact;

namespace {

Pattern notes() {
    Pattern pattern;
    pattern.amplitude_g = 0.8;
    pattern.carriers[0].frequency_hz = 180.0;
    pattern.rhythm = {"x=-x=---", 0.1};
    pattern.duration_s = 1.6;
    pattern.transients = {{0.72, 0.6, 120.0, 0.03}};
    return pattern;
}

std::string wave(const TemporaryFolder& folder, const char* name, const Waveform& waveform) {
    const auto path = folder.path / name;
    REQUIRE(write_wave_file(path, waveform));
    return path.string();
}

}  // namespace

TEST_CASE("from-sound: a rendered pattern becomes one again, and its PM from the sound is little") {
    const TemporaryFolder folder;
    const std::string file = wave(folder, "notes.wav", render(notes()));
    const std::string out = (folder.path / "out.tactspace.json").string();
    const auto report =
        nlohmann::json::parse(output_of({"from-sound", file, file, "--out", out, "--json"}));
    REQUIRE(report.size() == 2);
    CHECK(report[0].at("name") == "notes");
    CHECK(report[1].at("name") == "notes 2");
    CHECK(report[0].at("actuator") == "core-haptics");
    CHECK(report[0].at("accents") == 1);
    CHECK(report[0].at("pm").at("sections").size() == 2);
    const auto set = read_set_file(out);
    REQUIRE(set);
    REQUIRE(set->set.vibrations.size() == 2);
    const auto& got = std::get<Pattern>(set->set.vibrations[0].source);
    CHECK(got.duration_s == doctest::Approx(1.6));
    CHECK(std::abs(envelope_g(got, 0.1) - 0.8) <= 0.04);
    CHECK(envelope_g(got, 0.25) <= 0.02);
    CHECK(std::abs(first_carrier_hz(got, 0.1) - 180.0) <= 3.0);
    CHECK(set->set.vibrations[0].note.find("From the sound notes.wav") == 0);
}

TEST_CASE("from-sound: the actuator's band, full scale and accents are what the options say") {
    const TemporaryFolder folder;
    const std::string file = wave(folder, "notes.wav", render(notes()));
    const std::string out = (folder.path / "out.tactspace.json").string();
    const auto report = nlohmann::json::parse(
        output_of({"from-sound", file, "--out", out, "--actuator", "console-simple", "--full-scale",
                   "2", "--no-accents", "--without-loss", "--json"}));
    CHECK(report[0].at("accents") == 0);
    CHECK(report[0].at("full_scale_g") == 2.0);
    CHECK(!report[0].contains("pm"));
    const auto set = read_set_file(out);
    REQUIRE(set);
    const auto& got = std::get<Pattern>(set->set.vibrations[0].source);
    CHECK(got.carriers[0].frequency_hz == 60.0);
    CHECK(got.frequency_curve.empty());
}

TEST_CASE(
    "from-sound: what is silent or no sound is refused in a sentence, and nothing is written") {
    const TemporaryFolder folder;
    const std::string out = (folder.path / "out.tactspace.json").string();
    const std::string silent =
        wave(folder, "silent.wav", {kModelRateHz, std::vector<double>(1000, 0.0)});
    const std::string text = folder.write("song.mp3", "no song").string();
    CHECK(refusal_of({"from-sound", silent, "--out", out}).find("silent.wav: is silent") !=
          std::string::npos);
    CHECK(refusal_of({"from-sound", text, "--out", out}).find("expected a sound file") !=
          std::string::npos);
    CHECK(run_program({"from-sound", silent}).exit_code == 2);
    CHECK(
        refusal_of({"from-sound", silent, "--out", out, "--actuator", "none"}).find("--actuator") !=
        std::string::npos);
    CHECK(!std::filesystem::exists(out));
}

}  // namespace from_sound_command_test
