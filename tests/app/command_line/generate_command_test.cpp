// tactspace generate, as a person at a terminal uses it.
#include <doctest/doctest.h>

#include <nlohmann/json.hpp>

#include "model/io/set/set_file.h"
#include "tests/support/run_program.h"
#include "tests/support/temporary_folder.h"

namespace generate_command_test {

using namespace tact;

namespace {

constexpr const char* kSpec = R"({"amplitude_g": [0.5, 1], "duration_s": 0.2,
    "carriers": [{"frequency_hz": {"from": 60, "to": 240, "steps": 3, "spacing": "log"}}],
    "modulation": {"frequency_hz": [0, 8]}, "constraints": {"band_hz": [55, 400]}})";

}  // namespace

TEST_CASE("generate: a spec becomes a set that predict reads") {
    const TemporaryFolder folder;
    const std::string spec = folder.write("spec.json", kSpec).string();
    const std::string out = (folder.path / "out.tactspace.json").string();
    const auto json = nlohmann::json::parse(output_of({"generate", spec, "--out", out, "--json"}));
    CHECK(json.at("combinations") == 12);
    CHECK(json.at("rejected").at("band") == 2);
    CHECK(json.at("patterns") == 10);
    const auto set = read_set_file(out);
    REQUIRE(set);
    CHECK(set->set.vibrations.size() == 10);
    CHECK(cells_of(output_of({"predict", out})).size() == 11);
}

TEST_CASE("generate: a set with a generator keeps its own patterns, and twice is once") {
    const TemporaryFolder folder;
    const std::string set =
        folder
            .write("set.tactspace.json", std::string(R"({"tactspace": 1, "duration_s": 0.2,
                    "patterns": [{"name": "mine", "amplitude_g": 3}], "generator": )") +
                                             kSpec + "}")
            .string();
    const std::string once = (folder.path / "once.tactspace.json").string();
    const std::string twice = (folder.path / "twice.tactspace.json").string();
    output_of({"generate", set, "--out", once});
    output_of({"generate", once, "--out", twice});
    CHECK(bytes_of(once) == bytes_of(twice));
    CHECK(read_set_file(once)->set.vibrations.front().name == "mine");
    CHECK(read_set_file(once)->set.vibrations.size() == 11);
}

TEST_CASE("generate: counting writes nothing") {
    const TemporaryFolder folder;
    const std::string spec = folder.write("spec.json", kSpec).string();
    const std::string out = output_of({"generate", spec, "--count"});
    CHECK(contains(out, "12 combinations\n"));
    CHECK(contains(out, "2 rejected: outside the device's band\n"));
    CHECK(contains(out, "10 patterns\n"));
    CHECK(file_count(folder.path) == 1);
    CHECK(run_program({"generate", spec}).exit_code == 2);
}

TEST_CASE("generate: a bad spec gives one clear sentence and leaves no file") {
    const TemporaryFolder folder;
    const std::string out = (folder.path / "out.json").string();
    const auto refusal = [&](const char* text) {
        return refusal_of({"generate", folder.write("spec.json", text).string(), "--out", out});
    };
    CHECK(contains(refusal("{"), "line 1"));
    CHECK(contains(refusal(R"({"amplitude_g": 99})"),
                   "/amplitude_g: expected a number from 0 to 50, got 99"));
    CHECK(contains(refusal(R"({"amplitude_g": {"from": 0, "to": 1, "steps": 1000},
                               "attack_s": {"from": 0, "to": 1, "steps": 20}})"),
                   "the full factorial has 20,000 combinations"));
    CHECK(contains(refusal(R"({"patterns": []})"), "has no \"generator\""));
    CHECK(file_count(folder.path) == 1);
}

}  // namespace generate_command_test
