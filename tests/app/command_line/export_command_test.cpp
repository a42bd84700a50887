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

}  // namespace export_command_test
