// tactspace import and measure, as a person at a terminal uses them.
#include <doctest/doctest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "model/io/set/set_file.h"
#include "model/set/measured_twin.h"
#include "model/text/numbers.h"
#include "tests/support/run_program.h"
#include "tests/support/temporary_folder.h"

namespace measured_command_test {

using namespace tact;

namespace {

constexpr const char* kSet = R"({"tactspace": 1, "name": "three", "duration_s": 0.2, "patterns": [
    {"name": "low", "carriers": [{"frequency_hz": 60}], "rhythm": {"text": "x=-x----", "unit_s": 0.025}},
    {"name": "mid", "carriers": [{"frequency_hz": 150}], "rhythm": {"text": "x=-x----", "unit_s": 0.025}},
    {"name": "high", "carriers": [{"frequency_hz": 250}], "rhythm": {"text": "x---x---", "unit_s": 0.025}}],
    "ratings": [{"name": "p", "labels": ["low", "mid", "high"], "condensed": [0.3, 0.9, 0.5]}]})";

// The pattern as a logger in volts writes it, begun early: 0.4 V/g about 0.9 V.
std::string recorded(const PatternSet& set, const std::string& name) {
    std::string text = "Time [ms];Out (V)\n";
    const Waveform waveform = waveform_of(set.vibrations[*place_named(set, name)]);
    for (std::size_t n = 0; n < waveform.samples_g.size() + 500; ++n) {
        const double g = n < 500 ? 0.0 : waveform.samples_g[n - 500];
        text += shortest_digits(static_cast<double>(n) / 10.0) + ";" +
                shortest_digits(0.9 + 0.4 * g) + "\n";
    }
    return text;
}

}  // namespace

TEST_CASE("import: recordings stand behind the patterns that their files are named after") {
    const TemporaryFolder folder;
    const std::string file = folder.write("in/set.tactspace.json", kSet).string();
    const PatternSet set = read_set_file(file)->set;
    const std::string low = folder.write("low.csv", recorded(set, "low")).string();
    const std::string high = folder.write("High_measured.csv", recorded(set, "high")).string();
    const std::string out = (folder.path / "out.tactspace.json").string();
    const auto report =
        nlohmann::json::parse(output_of({"import", file, low, high, "--unit", "V", "--sensitivity",
                                         "0.4", "--offset", "0.9", "--out", out, "--json"}));
    REQUIRE(report.size() == 2);
    CHECK(report[0].at("measures") == "low");
    CHECK(report[0].at("lag_s") == 0.05);
    CHECK(report[1].at("measures") == "high");
    CHECK(report[1].at("correlation") > 0.999);
    const auto again = read_set_file(out);
    REQUIRE(again);
    const PatternSet& with = again->set;
    CHECK(names_of(with) ==
          std::vector<std::string>{"low", "low measured", "mid", "high", "high measured"});
    const Waveform intended = waveform_of(with.vibrations[0]);
    const Waveform measured = waveform_of(with.vibrations[1]);
    REQUIRE(measured.samples_g.size() == intended.samples_g.size());
    // A logger's offset cannot be told from the mean of the pattern: one and a half cycles have
    // one.
    const double offset_g = measured.samples_g[0] - intended.samples_g[0];
    CHECK(std::abs(offset_g) < 0.03);
    for (std::size_t n = 0; n < intended.samples_g.size(); ++n) {
        REQUIRE(std::abs(measured.samples_g[n] - intended.samples_g[n] - offset_g) < 1e-3);
    }
}

TEST_CASE("import: columns and their units may be told, and are held to the file") {
    const TemporaryFolder folder;
    const std::string file = folder.write("set.tactspace.json", kSet).string();
    std::string table = recorded(read_set_file(file)->set, "low");
    table.replace(0, table.find('\n'), "when;force");
    const std::string low = folder.write("low.csv", table).string();
    const std::string out = (folder.path / "out.tactspace.json").string();
    const std::vector<std::string> words{
        "import", file, low,      "--unit",      "V",  "--sensitivity", "0.4",  "--offset", "0.9",
        "--out",  out,  "--json", "--time-unit", "ms", "--decimal",     "point"};
    auto right = words;
    right.insert(right.end(), {"--columns", "time=when,x=force"});
    CHECK(nlohmann::json::parse(output_of(right))[0].at("lag_s") == 0.05);
    auto wrong = words;
    wrong.insert(wrong.end(), {"--columns", "time=when,x=weight"});
    const Ran refused = run_program(wrong);
    CHECK(refused.exit_code == 1);
    CHECK(refused.err.find("the columns are when, force") != std::string::npos);
    wrong.back() = "time=when,w=force";
    CHECK(run_program(wrong).exit_code != 0);
}

TEST_CASE("import: what it cannot place or read is refused, and nothing is written") {
    const TemporaryFolder folder;
    const std::string file = folder.write("set.tactspace.json", kSet).string();
    const std::string other = folder.write("other.csv", "t,x\n0,0\n0.0001,1\n").string();
    const std::string out = (folder.path / "out.tactspace.json").string();
    const auto nameless = run_program({"import", file, other, "--out", out});
    CHECK(nameless.exit_code == 1);
    CHECK(contains(nameless.err, "--pattern NAME says which it measures"));
    CHECK(run_program({"import", file, other, "--pattern", "none", "--out", out}).exit_code == 1);
    CHECK(run_program({"import", file, other, "--unit", "ft/s2", "--out", out}).exit_code == 2);
    CHECK(contains(
        refusal_of({"import", file, other, "--pattern", "low", "--unit", "V", "--out", out}),
        "expected the sensor's sensitivity in V/g"));
    CHECK(run_program({"import", file, other}).exit_code == 2);
    CHECK(file_count(folder.path) == 2);
}

TEST_CASE("measure: synthetic twins say so, and either side is predicted by itself") {
    const TemporaryFolder folder;
    const std::string file = folder.write("set.tactspace.json", kSet).string();
    const std::string out = (folder.path / "out.tactspace.json").string();
    CHECK(run_program({"measure", file, "--out", out}).exit_code == 2);
    const auto report = nlohmann::json::parse(output_of(
        {"measure", file, "--simulate", "--resonance", "90", "--q", "3", "--out", out, "--json"}));
    REQUIRE(report.size() == 3);
    CHECK(report[0].at("synthetic") == true);
    CHECK(report[0].at("name") == "low synthetic");
    CHECK(contains(bytes_of(out), "\"synthetic\": true"));
    const auto labels = [&out](const std::string& side) {
        return nlohmann::json::parse(output_of({"predict", out, "--only", side, "--json"}))
            .at("labels")
            .get<std::vector<std::string>>();
    };
    CHECK(labels("intended") == std::vector<std::string>{"low", "mid", "high"});
    CHECK(labels("measured") ==
          std::vector<std::string>{"low synthetic", "mid synthetic", "high synthetic"});
    CHECK(output_of({"predict", out, "--only", "intended"}) == output_of({"predict", file}));
    // Another run of the same leaves the same.
    const std::string bytes = bytes_of(out);
    output_of({"measure", file, "--simulate", "--resonance", "90", "--q", "3", "--out", out});
    CHECK(bytes_of(out) == bytes);
    CHECK(file_count(folder.path / "measured") == 3);
}

TEST_CASE("compare: twins are held against the ratings of what they measure") {
    const TemporaryFolder folder;
    const std::string file = folder.write("set.tactspace.json", kSet).string();
    const std::string out = (folder.path / "out.tactspace.json").string();
    output_of({"measure", file, "--simulate", "--out", out});
    CHECK(contains(output_of({"compare", out, "--only", "measured", "--metric", "rmse"}),
                   "three, measured: 3 patterns"));
    CHECK(contains(output_of({"compare", out, "--only", "intended", "--metric", "rmse"}),
                   "three, intended: 3 patterns"));
    // Twins were not rated: beside their patterns they are left out, and that is said.
    const auto both = run_program({"compare", out, "--metric", "rmse"});
    CHECK(both.exit_code == 0);
    CHECK(contains(both.out + both.err, "low synthetic"));
}

}  // namespace measured_command_test
