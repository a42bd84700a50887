// tactspace groups: what it prints and writes, and what it refuses.
#include <doctest/doctest.h>

#include <nlohmann/json.hpp>

#include "model/grouping/set_groups.h"
#include "model/io/set/set_file.h"
#include "model/perceptual_model/perceptual_model.h"
#include "model/set/pattern_set.h"
#include "tests/support/run_program.h"
#include "tests/support/temporary_folder.h"

namespace groups_command_test {

using Json = nlohmann::json;

namespace {

// Patterns of 0.1 s, as DTW is quadratic; nobody feels the last but one, and the last is dropped.
constexpr const char* kShortSet = R"({"tactspace": 1, "duration_s": 0.1, "patterns": [
    {"name": "a,1", "carriers": [{"frequency_hz": 150}]},
    {"name": "b", "carriers": [{"frequency_hz": 155}]},
    {"name": "c", "amplitude_g": 1.6, "carriers": [{"frequency_hz": 60}]},
    {"name": "d", "carriers": [{"frequency_hz": 250}], "modulation": {"frequency_hz": 20}},
    {"name": "e", "amplitude_g": 0.5, "carriers": [{"frequency_hz": 80}]},
    {"name": "faint", "amplitude_g": 0.00001, "carriers": [{"frequency_hz": 80}]},
    {"name": "out", "carriers": [{"frequency_hz": 90}], "dropped": true}]})";

struct ShortSet {
    TemporaryFolder folder;
    std::string path = folder.write("short.tactspace.json", kShortSet).string();
    std::string out = (folder.path / "groups.csv").string();
    std::string central = (folder.path / "central.tactspace.json").string();
    tact::PatternSet set = tact::read_set_file(path)->set;
    tact::Prediction prediction = *tact::predict(tact::model_waveforms(set), set.model);
    tact::SetGroups groups =
        tact::groups_of_set(set, prediction.pm, tact::unfelt(prediction.codes));

    std::vector<std::string> words(std::vector<std::string> more) const {
        more.insert(more.begin(), {"groups", path});
        return more;
    }
};

}  // namespace

TEST_CASE("groups command: JSON is the model's answer, by a number and by a cut") {
    const ShortSet s;
    const auto names = names_of(s.set);
    const auto cut = tact::groups_at(s.groups, s.prediction.pm, 3);
    const Json expected = tact::json_of(s.groups, cut, names);
    const Json by_count = Json::parse(output_of(s.words({"-n", "3", "--json"})));
    for (const auto& [key, value] : expected.items()) CHECK(by_count.at(key) == value);
    CHECK(by_count.at("not_felt") == Json{"faint"});
    CHECK(by_count.at("dropped") == Json{"out"});
    const double from = by_count.at("cut").at("from");
    const Json by_cut =
        Json::parse(output_of(s.words({"--cut", std::to_string(from + 1e-3), "--json"})));
    CHECK(by_cut == by_count);
    // Without a number: half of a small set; those that are apart do not count.
    CHECK(Json::parse(output_of(s.words({"--json"}))).at("count") == 3);
}

TEST_CASE("groups command: a table has each pattern once, a set file what stands for the groups") {
    const ShortSet s;
    const std::string text =
        output_of(s.words({"-n", "2", "--out", s.out, "--central", s.central}));
    const std::string table = bytes_of(s.out);
    CHECK(table.starts_with("pattern,group,central\n"));
    for (const char* row : {"\n\"a,1\",", "\nb,", "\nc,", "\nd,", "\ne,"})
        CHECK(contains(table, row));
    CHECK(contains(table, "\nfaint,not felt,0\n"));
    CHECK(contains(table, "\nout,dropped,0\n"));
    const auto kept = tact::read_set_file(s.central)->set;
    REQUIRE(kept.vibrations.size() == 2);
    for (const tact::Vibration& one : kept.vibrations)
        CHECK(contains(text, one.name + ", the most"));
    CHECK(contains(text, "2 groups of 5 patterns, cut at PM "));
    CHECK(contains(text, "not felt, apart: faint"));
}

TEST_CASE("groups command: a matrix of one's own takes the place of PM") {
    const ShortSet s;
    const std::string matrix = (s.folder.path / "m.csv").string();
    CHECK(run_program({"predict", s.path, "--out", matrix}).exit_code == 0);
    const Json by_pm = Json::parse(output_of(s.words({"-n", "2", "--json"})));
    const Json by_matrix =
        Json::parse(output_of(s.words({"-n", "2", "--matrix", matrix, "--json"})));
    CHECK(by_matrix.at("groups") == by_pm.at("groups"));
    CHECK(by_matrix.at("joins") == by_pm.at("joins"));
}

TEST_CASE("groups command: more groups than patterns, and a number beside a cut, are refused") {
    const ShortSet s;
    CHECK(contains(refusal_of(s.words({"-n", "6"})), "--count: expected at most 5"));
    CHECK(run_program(s.words({"-n", "2", "--cut", "3"})).exit_code == 2);
}

}  // namespace groups_command_test
