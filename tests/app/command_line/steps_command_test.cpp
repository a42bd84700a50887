// tactspace steps: what it writes, what it says, and what it refuses.
#include <doctest/doctest.h>

#include <nlohmann/json.hpp>

#include "model/ask/steps.h"
#include "model/io/set/set_file.h"
#include "tests/support/run_program.h"
#include "tests/support/temporary_folder.h"

namespace steps_command_test {

using StepsJson = nlohmann::json;

namespace {

constexpr const char* kTwoEnds = R"({"tactspace": 1, "duration_s": 0.1, "patterns": [
    {"name": "weak", "amplitude_g": 0.4, "carriers": [{"frequency_hz": 150}]},
    {"name": "strong", "amplitude_g": 1.6, "carriers": [{"frequency_hz": 200}], "locked": true},
    {"name": "other", "carriers": [{"frequency_hz": 60}]}]})";

struct Ends {
    TemporaryFolder folder;
    std::string path = folder.write("ends.tactspace.json", kTwoEnds).string();
    std::string out = (folder.path / "steps.tactspace.json").string();

    std::vector<std::string> words(std::vector<std::string> more) const {
        std::vector<std::string> all{"steps", path, "--out", out};
        all.insert(all.end(), more.begin(), more.end());
        return all;
    }
};

}  // namespace

TEST_CASE("steps command: the written set is the way, its ends as they were") {
    const Ends ends;
    const StepsJson json = StepsJson::parse(
        output_of(ends.words({"--from", "weak", "--to", "strong", "-n", "4", "--json"})));
    const tact::PatternSet before = tact::read_set_file(ends.path)->set;
    const tact::PatternSet written = tact::read_set_file(ends.out)->set;
    REQUIRE(written.vibrations.size() == 4);
    CHECK(written.vibrations.front() == before.vibrations[0]);
    CHECK(written.vibrations.back() == before.vibrations[1]);
    CHECK(written.vibrations[1].name == "weak to strong 2");
    CHECK(json["patterns"].size() == 4);
    CHECK(json["apart"].size() == 3);
    CHECK(json["even"] == (json["uneven"].get<double>() <= tact::kEvenWithin));
    CHECK(json.contains("jump") != json["even"].get<bool>());
    const auto& own = std::get<tact::Pattern>(written.vibrations[1].source);
    CHECK(own.amplitude_g > 0.4);
    CHECK(own.amplitude_g < 1.6);
}

TEST_CASE("steps command: along one number the end is a pattern of its own") {
    const Ends ends;
    const std::string text = output_of(
        ends.words({"--from", "weak", "--to", "strong", "-n", "3", "--parameter", "amplitude_g"}));
    CHECK(text.find("in continuous PM") != std::string::npos);
    CHECK(text.find("PM counts ranks") != std::string::npos);
    const tact::PatternSet written = tact::read_set_file(ends.out)->set;
    REQUIRE(written.vibrations.size() == 3);
    CHECK(written.vibrations[2].name == "weak to strong 3");
    const auto& last = std::get<tact::Pattern>(written.vibrations[2].source);
    CHECK(last.amplitude_g == 1.6);
    CHECK(last.carriers[0].frequency_hz == 150.0);
}

TEST_CASE("steps command: what cannot be is refused") {
    const Ends ends;
    CHECK(refusal_of(ends.words({"--from", "weak", "--to", "nobody"})).find("--to") !=
          std::string::npos);
    CHECK(refusal_of(ends.words({"--from", "weak", "--to", "weak"})).find("another") !=
          std::string::npos);
    CHECK(refusal_of(ends.words({"--from", "weak", "--to", "strong", "--parameter", "colour"}))
              .find("amplitude_g") != std::string::npos);
    CHECK(run_program(ends.words({"--from", "weak", "--to", "strong", "-n", "17"})).exit_code == 2);
    CHECK(run_program({"steps", ends.path, "--from", "weak", "--to", "strong"}).exit_code == 2);
}

}  // namespace steps_command_test
