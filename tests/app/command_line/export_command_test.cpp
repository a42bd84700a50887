// Patterns as files of other programs, by the command line.
#include <doctest/doctest.h>

#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>

#include "tests/support/run_program.h"
#include "tests/support/temporary_folder.h"

namespace export_command_test {

namespace fs = std::filesystem;

namespace {

const std::string kTwo = R"({"tactspace": 1, "patterns": [
  {"name": "low/buzz", "amplitude_g": 0.5, "carriers": [{"frequency_hz": 30}]},
  {"name": "tone", "amplitude_g": 0.25, "carriers": [{"frequency_hz": 150}]}]})";

bool contains(const std::string& text, const std::string& words) {
    return text.find(words) != text.npos;
}

std::string bytes_in(const fs::path& path) {
    std::ifstream stream(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

}  // namespace

TEST_CASE("export: a file a pattern, each with what it loses") {
    const TemporaryFolder folder;
    folder.write("two.tactspace.json", kTwo);
    const std::string set = (folder.path / "two.tactspace.json").string();
    const fs::path out = folder.path / "phone";
    const Ran ran = run_program({"export", set, "--format", "ahap", "--out", out.string()});
    CHECK(ran.exit_code == 0);
    CHECK(fs::exists(out / "low-buzz.ahap"));
    CHECK(fs::exists(out / "tone.ahap"));
    CHECK(contains(ran.out, "30 Hz is out of the band, written as 65 Hz"));
    CHECK(contains(ran.out, "nothing lost"));
    CHECK(contains(ran.err, "actuator core-haptics: "));
    CHECK(contains(ran.err, "is assumed: nobody publishes it"));
}

TEST_CASE("export: nothing is overwritten without a word, and then nothing at all is written") {
    const TemporaryFolder folder;
    folder.write("two.tactspace.json", kTwo);
    folder.write("tone.haptic", "mine");
    const std::string set = (folder.path / "two.tactspace.json").string();
    std::vector<std::string> words{"export", set,     "--format",
                                   "haptic", "--out", folder.path.string()};
    const std::string refusal = refusal_of(words);
    CHECK(
        contains(refusal, "tone.haptic: is there already, expected another folder or --overwrite"));
    CHECK(bytes_in(folder.path / "tone.haptic") == "mine");
    CHECK_FALSE(fs::exists(folder.path / "low-buzz.haptic"));
    words.emplace_back("--overwrite");
    CHECK(run_program(words).exit_code == 0);
    CHECK(bytes_in(folder.path / "tone.haptic").starts_with("{"));
}

TEST_CASE("export: one pattern onto a chosen actuator, as JSON") {
    const TemporaryFolder folder;
    folder.write("two.tactspace.json", kTwo);
    const std::string set = (folder.path / "two.tactspace.json").string();
    const Ran ran =
        run_program({"export", set, "--format", "haptic", "--pattern", "low/buzz", "--onto",
                     "console-pcm", "--json", "--out", (folder.path / "one").string()});
    REQUIRE(ran.exit_code == 0);
    const auto answer = nlohmann::json::parse(ran.out);
    CHECK(answer.at("format") == "haptic");
    CHECK(answer.at("actuator") == "console-pcm");
    REQUIRE(answer.at("files").size() == 1);
    CHECK(answer.at("files")[0].at("pattern") == "low/buzz");
    CHECK(answer.at("files")[0].at("remarks").empty());
    CHECK_FALSE(fs::exists(folder.path / "one" / "tone.haptic"));
}

TEST_CASE("export: a pattern that is not there is refused before anything is written") {
    const TemporaryFolder folder;
    folder.write("two.tactspace.json", kTwo);
    const std::string set = (folder.path / "two.tactspace.json").string();
    const std::string refusal = refusal_of({"export", set, "--format", "pulsar", "--pattern",
                                            "tune", "--out", (folder.path / "none").string()});
    CHECK(contains(refusal, "tune"));
    CHECK_FALSE(fs::exists(folder.path / "none"));
}

TEST_CASE("export: WAV and CSV at a rate, with their full scale beside them, and recordings too") {
    const TemporaryFolder folder;
    folder.write("two.tactspace.json", kTwo);
    const std::string set = (folder.path / "two.tactspace.json").string();
    const fs::path out = folder.path / "waves";
    const Ran ran = run_program({"export", set, "--format", "wav", "--rate", "44100", "--bits",
                                 "16", "--no-loss", "--json", "--out", out.string()});
    REQUIRE(ran.exit_code == 0);
    const auto answer = nlohmann::json::parse(ran.out);
    CHECK(answer.at("rate_hz") == 44100.0);
    CHECK(answer.at("bits") == "16");
    CHECK_FALSE(answer.contains("actuator"));
    const double full_g = answer.at("full_scale_g");
    CHECK(full_g == doctest::Approx(0.5).epsilon(1e-3));
    CHECK(contains(ran.err, "full scale: "));
    const auto beside = nlohmann::json::parse(bytes_in(out / "tone.wav.json"));
    CHECK(beside.at("scale_g") == full_g);
    CHECK(bytes_in(out / "tone.wav").size() == 44 + 2 * 44100);
    // What is written is a set.
    const Ran back = run_program({"export", out.string(), "--format", "csv", "--no-loss", "--out",
                                  (folder.path / "csv").string()});
    CHECK(back.exit_code == 0);
    CHECK(bytes_in(folder.path / "csv" / "tone.csv").starts_with("time_s,acceleration_g\n0,"));
    // Over neither of the two files unasked.
    fs::remove(out / "low-buzz.wav");
    fs::remove(out / "tone.wav");
    const std::string refusal =
        refusal_of({"export", set, "--format", "wav", "--no-loss", "--out", out.string()});
    CHECK(contains(refusal, ".wav.json: is there already"));
}

TEST_CASE("export: rate and bits are those of samples alone, and so is no actuator") {
    const TemporaryFolder folder;
    folder.write("two.tactspace.json", kTwo);
    const std::string set = (folder.path / "two.tactspace.json").string();
    const std::string out = (folder.path / "none").string();
    const auto refused = [&](std::vector<std::string> more, const std::string& words) {
        std::vector<std::string> all{"export", set, "--out", out};
        all.insert(all.end(), more.begin(), more.end());
        CHECK(contains(refusal_of(all), words));
    };
    refused({"--format", "ahap", "--rate", "48000"}, "--rate: expected --format wav or csv");
    refused({"--format", "csv", "--bits", "16"}, "--bits: expected --format wav, got csv");
    refused({"--format", "wav", "--onto", "quest"}, "expected no actuator, wav holds g");
    CHECK_FALSE(fs::exists(folder.path / "none"));
}

TEST_CASE("export: a pair of AHAP is written as two files, predicted as one, and read as one") {
    const TemporaryFolder folder;
    folder.write("taps.tactspace.json", R"({"tactspace": 1, "patterns": [
      {"name": "a", "amplitude_g": 0.5, "duration_s": 0.2, "amplitude_curve": [
        {"time_s": 0, "value": 0.2}, {"time_s": 0.2, "value": 1}],
       "transients": [{"time_s": 0.05, "amplitude_g": 0.7, "frequency_hz": 150, "duration_s": 0.022}]},
      {"name": "b", "amplitude_g": 0.25, "duration_s": 0.2}]})");
    const std::string set = (folder.path / "taps.tactspace.json").string();
    const fs::path out = folder.path / "pair";
    const Ran ran =
        run_program({"export", set, "--format", "ahap-pair", "--json", "--out", out.string()});
    REQUIRE(ran.exit_code == 0);
    const auto answer = nlohmann::json::parse(ran.out);
    CHECK(answer.at("files")[0].at("beside") == (out / "a_transients.ahap").string());
    CHECK(answer.at("loss").at("patterns")[0].at("rms_error_g").get<double>() < 1e-3);
    const Ran back = run_program({"predict", out.string(), "--json"});
    REQUIRE(back.exit_code == 0);
    const auto predicted = nlohmann::json::parse(back.out);
    CHECK(predicted.at("labels") == nlohmann::json::array({"a", "b"}));
    CHECK(contains(back.err, "actuator map core-haptics ("));
    const Ran placed = run_program({"subset", out.string(), "-k", "2", "--json"});
    REQUIRE(placed.exit_code == 0);
    CHECK(nlohmann::json::parse(placed.out).at("actuators") == nlohmann::json{{"core-haptics", 2}});
}

TEST_CASE("export: onto the map by which effects were read, where somebody chose it") {
    const TemporaryFolder folder;
    folder.write("in/a.haptic",
                 R"({"version": {"major": 1}, "signals": {"continuous": {"envelopes": {"amplitude":
                 [{"time": 0, "amplitude": 1}, {"time": 0.1, "amplitude": 0}]}}}})");
    const std::string in = (folder.path / "in").string();
    const auto onto = [&](const std::vector<std::string>& more) {
        std::vector<std::string> words{"export",      in,          "--format",
                                       "haptic",      "--no-loss", "--json",
                                       "--overwrite", "--out",     (folder.path / "out").string()};
        words.insert(words.end(), more.begin(), more.end());
        const Ran ran = run_program(words);
        REQUIRE(ran.exit_code == 0);
        return nlohmann::json::parse(ran.out).at("actuator").get<std::string>();
    };
    CHECK(onto({}) == "quest");
    CHECK(onto({"--actuator", "console-pcm"}) == "console-pcm");
    CHECK(onto({"--actuator", "console-pcm", "--onto", "android"}) == "android");
}

}  // namespace export_command_test
