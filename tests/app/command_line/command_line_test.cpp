// The commands on good input: what they print, and that it is the model's.
#include "app/command_line/command_line.h"

#include <doctest/doctest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "model/evaluation/metric_matrix.h"
#include "model/io/set/set_file.h"
#include "tests/support/bundled_sets.h"
#include "tests/support/five_patterns.h"
#include "tests/support/places.h"
#include "tests/support/run_program.h"
#include "tests/support/temporary_folder.h"

namespace command_line_test {

namespace fs = std::filesystem;
using Json = nlohmann::json;
using tact::ShortSet;

namespace {

double farthest(const std::vector<double>& got, const std::vector<double>& expected) {
    REQUIRE(got.size() == expected.size());
    double worst = 0.0;
    for (std::size_t k = 0; k < got.size(); ++k) {
        worst = std::max(worst, std::abs(got[k] - expected[k]));
    }
    return worst;
}

}  // namespace

// The numbers of the next three cases were printed by an independent program in double precision,
// tests/golden/reference_model.py, for the paper's eight amplitude-modulated patterns.
TEST_CASE("predict: eight text files of the AM patterns give the 28 known numbers, exactly" *
          doctest::test_suite("long")) {
    const Rendered am(kAmSet, "txt");
    const Ran ran = run_program({"predict", am.path, "--threads", "1"});
    CHECK(ran.exit_code == 0);
    CHECK(ran.err == "");
    CHECK(output_of({"predict", am.path, "--threads", "2"}) == ran.out);
    CHECK(output_of({"predict", am.path, "--threads", "4"}) == ran.out);
    CHECK(ran.out.starts_with(",AM-0,AM-1,AM-2,AM-5,AM-10,AM-20,AM-40,AM-80\nAM-0,0,19,22,"));
    CHECK(std::ranges::count(ran.out, '\n') == 9);
    CHECK(condensed_in(ran.out) == std::vector<double>{19,   22,  22,   18,   10, 2,    3.5,
                                                       8.5,  19,  20.5, 19,   17, 19.5, 14,
                                                       15.5, 18,  21.5, 23.5, 7,  10.5, 19.5,
                                                       24,   5.5, 11.5, 20.5, 5,  7.5,  2.5});
}

TEST_CASE("predict: NC and OC of the AM patterns are the known ones to the digits printed") {
    const Rendered am(kAmSet, "txt");
    const auto first_seven = [&am](const std::string& metric) {
        auto all = condensed_in(output_of({"predict", am.path, "--metric", metric}));
        all.resize(7);
        return all;
    };
    constexpr double kHalfOfLastDigit = 0.5e-3;
    CHECK(farthest(first_seven("nc"), {0.345, 0.342, 0.321, 0.279, 0.148, 0.124, 0.205}) <=
          kHalfOfLastDigit);
    CHECK(farthest(first_seven("oc"), {2184.276, 2383.931, 2484.775, 2447.264, 2158.941, 824.318,
                                       784.763}) <= kHalfOfLastDigit);
}

TEST_CASE("predict: every metric by its key gives the model's numbers, exactly") {
    const ShortSet set;
    const auto read = tact::parse_set(tact::five_patterns(), "short", {});
    REQUIRE(read);
    std::vector<tact::Waveform> waveforms;
    for (const auto& vibration : read->vibrations) {
        waveforms.push_back(tact::waveform_of(vibration));
    }
    for (const tact::Metric metric : tact::kMetrics) {
        const std::string key = tact::traits(metric).key;
        CAPTURE(key);
        auto expected = tact::metric_matrix(metric, waveforms, {});
        REQUIRE(expected);
        expected = tact::as_ranked(metric, *std::move(expected));
        CHECK(condensed_in(output_of({"predict", set.path, "--metric", key})) ==
              expected->condensed);
    }
}

TEST_CASE("predict --first-as-reference: the two ways have the mean for their sum's half") {
    const TemporaryFolder folder;
    const std::string there = folder
                                  .write("there.json", R"({"tactspace": 1, "patterns": [
        {"name": "a", "carriers": [{"frequency_hz": 70}]},
        {"name": "b", "carriers": [{"frequency_hz": 110}], "amplitude_g": 0.7}]})")
                                  .string();
    const std::string back = folder
                                 .write("back.json", R"({"tactspace": 1, "patterns": [
        {"name": "b", "carriers": [{"frequency_hz": 110}], "amplitude_g": 0.7},
        {"name": "a", "carriers": [{"frequency_hz": 70}]}]})")
                                 .string();
    for (const std::string metric : {"st-sim", "spqi"}) {
        const auto value = [&](const std::string& set, std::vector<std::string> more) {
            more.insert(more.begin(), {"predict", set, "--metric", metric});
            return condensed_in(output_of(more)).at(0);
        };
        const double one_way = value(there, {"--first-as-reference"});
        const double other_way = value(back, {"--first-as-reference"});
        CHECK(one_way != other_way);
        CHECK(value(there, {}) == (one_way + other_way) / 2.0);
        CHECK(value(back, {}) == value(there, {}));
    }
}

TEST_CASE("predict and space: the same bytes for any number of threads") {
    const ShortSet set;
    for (const std::string metric : {"pm", "nc", "oc"}) {
        const auto with = [&](const char* threads) {
            return output_of({"predict", set.path, "--metric", metric, "--threads", threads});
        };
        const std::string one = with("1");
        CHECK(with("2") == one);
        CHECK(with("4") == one);
    }
    const std::string one = output_of({"space", set.path, "--threads", "1"});
    CHECK(output_of({"space", set.path, "--threads", "2"}) == one);
    CHECK(output_of({"space", set.path, "--threads", "4"}) == one);
}

TEST_CASE("predict: the matrix is symmetric with zeros on its diagonal") {
    const ShortSet set;
    const auto rows = cells_of(output_of({"predict", set.path, "--metric", "oc"}));
    REQUIRE(rows.size() == 6);
    for (std::size_t i = 1; i < rows.size(); ++i) {
        CHECK(rows[i][0] == rows[0][i]);
        CHECK(rows[i][i] == "0");
        for (std::size_t j = 1; j < i; ++j) CHECK(rows[i][j] == rows[j][i]);
    }
}

TEST_CASE("predict --json: labels, metric and condensed, and nothing else") {
    const std::vector<std::string> predict{"predict", kAmSet, "--metric", "nc"};
    auto with_json = predict;
    with_json.emplace_back("--json");
    const Json json = Json::parse(output_of(with_json));
    CHECK(json.size() == 3);
    CHECK(json.at("metric") == "nc");
    CHECK(json.at("labels") ==
          Json::array({"AM-0", "AM-1", "AM-2", "AM-5", "AM-10", "AM-20", "AM-40", "AM-80"}));
    CHECK(json.at("condensed").get<std::vector<double>>() == condensed_in(output_of(predict)));
}

TEST_CASE("space: labels, coordinates and stress, the same numbers as JSON and as CSV") {
    const ShortSet set;
    for (const std::size_t dimensions : {2U, 3U}) {
        const std::string dim = std::to_string(dimensions);
        const Ran ran = run_program({"space", set.path, "--dim", dim, "--json"});
        REQUIRE(ran.exit_code == 0);
        const Json json = Json::parse(ran.out);
        CHECK(json.size() == 3);
        CHECK(json.at("labels").size() == 5);
        CHECK(json.at("stress1").get<double>() >= 0.0);
        CHECK(ran.err.starts_with("tactspace: stress-1 "));
        const auto rows = cells_of(output_of({"space", set.path, "--dim", dim}));
        REQUIRE(rows.size() == 6);
        for (std::size_t i = 0; i < 5; ++i) {
            const Json& point = json.at("coordinates").at(i);
            CHECK(point.size() == dimensions);
            CHECK(rows[i + 1].size() == dimensions + 1);
            CHECK(rows[i + 1][0] == json.at("labels").at(i).get<std::string>());
            for (std::size_t k = 0; k < dimensions; ++k) {
                CHECK(std::stod(rows[i + 1][k + 1]) == point.at(k).get<double>());
            }
        }
    }
}

TEST_CASE("--out: the file has the bytes of standard output, which stays empty") {
    const ShortSet set;
    const TemporaryFolder folder;
    for (const std::string command : {"predict", "space"}) {
        const fs::path file = folder.path / (command + ".csv");
        CHECK(output_of({command, set.path, "--out", file.string()}) == "");
        CHECK(bytes_of(file) == output_of({command, set.path}));
    }
    CHECK(file_count(folder.path) == 2);  // nothing is left beside them
}

TEST_CASE("predict: names with commas, quotes and line breaks stand in the CSV as RFC 4180 says") {
    const TemporaryFolder folder;
    const fs::path set = folder.write("names.json", R"({"tactspace": 1, "patterns": [
        {"name": "a,b", "duration_s": 0.05}, {"name": "say \"c\"", "duration_s": 0.05},
        {"name": "line\nbreak", "duration_s": 0.05}]})");
    const std::string csv = output_of({"predict", set.string()});
    CHECK(csv.starts_with(",\"a,b\",\"say \"\"c\"\"\",\"line\nbreak\"\n\"a,b\",0,"));
}

TEST_CASE("SET: several are taken as one, in their order") {
    const Rendered am(kAmSet, "txt");
    const std::string csv = output_of(
        {"predict", am.path + "/AM-80.txt", am.path + "/AM-0.txt", kTwelve, "--metric", "nc"});
    CHECK(csv.starts_with(",AM-80,AM-0,L-0-half,"));
    CHECK(cells_of(csv).size() == 15);
}

TEST_CASE("--help and --version answer on standard output and end well") {
    CHECK(output_of({"--version"}).find_first_not_of("0123456789.\n") == std::string::npos);
    const std::string all = output_of({"--help"});
    for (const std::string command : {"predict", "space", "stages", "render", "snapshot", "play"}) {
        CHECK(contains(all, "\n  " + command + " "));
        const std::string help = output_of({command, "--help"});
        CHECK(contains(help, "Usage: tactspace " + command));
        CHECK(contains(help, "--threads"));
        CHECK(contains(help, "--json"));
    }
}

}  // namespace command_line_test
