// tactspace edit: edits in the order given, the same answer as the model's, and what it refuses.
#include <doctest/doctest.h>

#include <nlohmann/json.hpp>

#include "model/algebra/set_edits.h"
#include "model/io/set/set_file.h"
#include "tests/support/run_program.h"
#include "tests/support/temporary_folder.h"

namespace edit_command_test {

using namespace tact;

namespace {

constexpr const char* kThree = R"({"tactspace": 1, "patterns": [
    {"name": "buzz", "rhythm": {"text": "x=-x", "unit_s": 0.125}, "duration_s": 1},
    {"name": "tick", "amplitude_g": 0, "duration_s": 0.25,
     "transients": [{"time_s": 0.05, "amplitude_g": 1, "frequency_hz": 200, "duration_s": 0.02}]},
    {"name": "kept", "locked": true}], "ratings": []})";

struct Three {
    TemporaryFolder folder;
    std::string path = folder.write("three.tactspace.json", kThree).string();
    std::string out = (folder.path / "edited.tactspace.json").string();

    std::vector<std::string> words(std::vector<std::string> more) const {
        std::vector<std::string> all{"edit", path, "--out", out};
        all.insert(all.end(), more.begin(), more.end());
        return all;
    }
    PatternSet set() const { return read_set_file(path)->set; }
    PatternSet edited() const { return read_set_file(out)->set; }
    std::string fault(const std::vector<std::string>& more) const {
        return run_program(words(more)).err;
    }
};

}  // namespace

TEST_CASE("edit command: edits are applied in the order given, and are the model's") {
    const Three three;
    const std::vector<std::string> names{"buzz"};
    const auto by_model = [&](const std::vector<NamedEdit>& edits) {
        return *with_edits(three.set(), names, edits);
    };
    output_of(three.words({"--pattern", "buzz", "--stretch", "1.2", "--reverse", "--repeat", "2",
                           "--join", "tick", "--stretch", "0.5"}));
    const PatternSet one = three.edited();
    CHECK(one == by_model({{EditKind::stretch, 1.2},
                           {EditKind::reverse},
                           {EditKind::repeat, 2.0},
                           {EditKind::join, 0.0, "tick"},
                           {EditKind::stretch, 0.5}}));
    output_of(three.words({"--pattern", "buzz", "--stretch", "0.5", "--join", "tick", "--stretch",
                           "1.2", "--repeat", "2", "--reverse"}));
    CHECK(!(three.edited() == one));
    CHECK(three.edited() == by_model({{EditKind::stretch, 0.5},
                                      {EditKind::join, 0.0, "tick"},
                                      {EditKind::stretch, 1.2},
                                      {EditKind::repeat, 2.0},
                                      {EditKind::reverse}}));
}

TEST_CASE("edit command: without a name all that are not locked, with --as a new one beside") {
    const Three three;
    const auto json =
        nlohmann::json::parse(output_of(three.words({"--normalise", "0.5", "--json"})));
    REQUIRE(json.at("changed").size() == 2);
    CHECK(json.at("changed")[1].at("pattern") == "tick");
    CHECK(three.edited().vibrations[2] == three.set().vibrations[2]);
    // What cannot be edited is told, and stays.
    const Ran most = run_program(three.words({"--transpose", "5"}));
    CHECK(most.exit_code == 0);
    CHECK(most.err.find("left as it was: \"tick\", transpose: transients/0/frequency_hz") ==
          std::string::npos);
    const Ran some = run_program(three.words({"--transpose", "6"}));
    CHECK(some.exit_code == 0);
    CHECK(some.err ==
          "tactspace: left as it was: \"tick\", transpose: transients/0/frequency_hz: expected a "
          "number from 0.1 to 1000, got 1200\n");
    output_of(three.words({"--pattern", "buzz", "--trim", "--as", "short"}));
    CHECK(names_of(three.edited()) == std::vector<std::string>{"buzz", "short", "tick", "kept"});
    CHECK(std::get<Pattern>(three.edited().vibrations[1].source).rhythm.text == "x=-x");
}

TEST_CASE("edit command: what it cannot do is one sentence, and nothing is written") {
    const Three three;
    const auto fault = [&](const std::vector<std::string>& more) { return three.fault(more); };
    CHECK(fault({"--pattern", "buzz"}).find("an edit, such as --reverse") != std::string::npos);
    CHECK(fault({"--pattern", "kept", "--reverse"}) ==
          "tactspace: \"kept\" is locked: unlock it to edit it\n");
    CHECK(fault({"--reverse", "--as", "new"}).find("--as: expected one --pattern, got 0") !=
          std::string::npos);
    CHECK(fault({"--pattern", "buzz", "--join", "nobody"}) ==
          "tactspace: join: there is no pattern \"nobody\", expected one of buzz, tick, kept\n");
    CHECK(fault({"--pattern", "buzz", "--repeat", "100"}) ==
          "tactspace: \"buzz\", repeat: expected a duration of at most 60 s, got 100 s\n");
    CHECK(fault({"--pattern", "buzz", "--stretch", "0"}).find("--stretch") != std::string::npos);
    CHECK(!std::filesystem::exists(three.out));
}

}  // namespace edit_command_test
