// tactspace space: maps of metrics, of people and of matrices, and one turned onto another.
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "model/dissimilarity/correlation.h"
#include "model/io/set/set_file.h"
#include "model/io/tables/matrix_file.h"
#include "tests/support/five_patterns.h"
#include "tests/support/run_program.h"
#include "tests/support/temporary_folder.h"

namespace space_command_test {

using tact::five_patterns;
using Json = nlohmann::json;

namespace {

struct Maps {
    TemporaryFolder folder;
    std::string set = folder.write("five.tactspace.json", five_patterns()).string();

    std::string at(const char* name) const { return (folder.path / name).string(); }
    std::string made(const char* name, std::vector<std::string> words) const {
        words.insert(words.end(), {"--out", at(name)});
        output_of(words);
        return at(name);
    }
};

double farthest(const Json& a, const Json& b) {
    double worst = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        for (std::size_t k = 0; k < a[i].size(); ++k) {
            worst = std::max(worst, std::abs(a[i][k].get<double>() - b[i][k].get<double>()));
        }
    }
    return worst;
}

}  // namespace

TEST_CASE("space: of a metric, of a matrix with its numbers and of people who say them, one map") {
    const Maps maps;
    const std::string matrix = maps.made("nc.csv", {"predict", maps.set, "--metric", "nc"});
    const auto map = [&maps](std::vector<std::string> words) {
        words.insert(words.begin(), {"space", maps.set, "--json"});
        return Json::parse(output_of(words));
    };
    const Json by_metric = map({"--metric", "nc"});
    CHECK(map({"--matrix", matrix}).at("coordinates") == by_metric.at("coordinates"));
    const Json people = map({"--ratings", matrix, "--scale", "dissimilarity"});
    CHECK(people.at("coordinates") == by_metric.at("coordinates"));
    CHECK(people.at("synthetic") == false);
    CHECK(map({"--metric", "pm"}) == map({}));
    CHECK_FALSE(map({}).contains("synthetic"));
    CHECK(run_program({"space", maps.set, "--metric", "nc", "--matrix", matrix}).exit_code == 2);
    CHECK(run_program({"space", maps.set, "--people", "--matrix", matrix}).exit_code == 2);
    CHECK(contains(refusal_of({"space", maps.set, "--people"}), "has no ratings of its own"));
}

TEST_CASE("space --json: that a model is synthetic is said once, by the key of other commands") {
    const Maps maps;
    auto loaded = *tact::read_set_file(maps.set);
    loaded.set.model.nc_weight = 0.3;
    loaded.set.model_origin = {"Trained on drawn.", true, false};
    REQUIRE(tact::write_set_file(maps.set, loaded.set));
    const Json map = Json::parse(output_of({"space", maps.set, "--json"}));
    CHECK(map.at("synthetic_model") == true);
    CHECK_FALSE(map.contains("mark"));
    // A matrix has its mark in its own file alone.
    const std::string matrix = maps.made("pm.csv", {"predict", maps.set});
    const Json of_matrix =
        Json::parse(output_of({"space", maps.set, "--matrix", matrix, "--json"}));
    CHECK(contains(of_matrix.at("mark").get<std::string>(), "SYNTHETIC"));
    CHECK_FALSE(of_matrix.contains("synthetic_model"));
}

TEST_CASE("commands: zeros of a model that weighs nothing are said to be no answer") {
    const Maps maps;
    auto loaded = *tact::read_set_file(maps.set);
    const std::vector<std::string> names{loaded.set.vibrations[0].name,
                                         loaded.set.vibrations[1].name};
    for (const double weight : {0.0, 0.3}) {
        loaded.set.model.nc_weight = weight;
        loaded.set.model.oc_weight = 0.0;
        REQUIRE(tact::write_set_file(maps.set, loaded.set));
        for (const std::vector<std::string>& command : std::vector<std::vector<std::string>>{
                 {"predict", maps.set},
                 {"subset", maps.set, "-k", "2"},
                 {"space", maps.set},
                 {"separate", maps.set, "--pair", names[0] + "," + names[1]}}) {
            CAPTURE(command.front());
            CHECK(contains(run_program(command).err, "weighs neither NC nor OC") ==
                  (weight == 0.0));
        }
    }
}

TEST_CASE("space --align-to: a map turned onto itself stays, and another is told by how much") {
    const Maps maps;
    const std::string pm = maps.made("pm.csv", {"space", maps.set});
    const Json before = Json::parse(output_of({"space", maps.set, "--json"}));
    const Json same = Json::parse(output_of({"space", maps.set, "--align-to", pm, "--json"}));
    CHECK(farthest(same.at("coordinates"), before.at("coordinates")) <= 1e-12);
    CHECK(same.at("aligned").at("procrustes_m2").get<double>() <= 1e-12);
    CHECK(same.at("aligned").at("K").get<double>() <= 1e-12);
    // Five patterns: all 120 orders are tried.
    CHECK(same.at("aligned").at("protest_p") == 1.0 / 120.0);
    CHECK(same.at("aligned").at("patterns") == 5);
    const std::string picture = maps.at("nc.png");
    const Ran other = run_program(
        {"space", maps.set, "--metric", "nc", "--align-to", pm, "--json", "--image", picture});
    CHECK(contains(other.err, "turned onto the other map by 5 patterns: Procrustes m2 0."));
    CHECK(contains(other.err, "one-sided, all orders of the patterns"));
    CHECK(Json::parse(other.out).at("aligned").at("procrustes_m2").get<double>() > 1e-6);
    CHECK(std::filesystem::file_size(picture) > 1000);
}

TEST_CASE("space --align-to: what two maps have not in common is refused by name of the file") {
    const Maps maps;
    const std::string flat = maps.made("flat.csv", {"space", maps.set, "--dim", "2"});
    CHECK(contains(refusal_of({"space", maps.set, "--align-to", flat}),
                   "flat.csv: expected a map of 3 dimensions, got 2"));
    const std::string two =
        maps.folder.write("two.csv", "name,D1,D2,D3\nv 1,0,0,1\nv 2,1,0,0\nother,0,1,0\n").string();
    CHECK(contains(refusal_of({"space", maps.set, "--align-to", two}),
                   "two.csv: expected at least three patterns of the set, got 2"));
    CHECK(contains(refusal_of({"space", maps.set, "--align-to", maps.at("none.csv")}), "none.csv"));
}

TEST_CASE("predict --metric oc: ties are printed as ties, so that a rank of one's own is ours") {
    const Maps maps;
    const auto oc =
        tact::read_matrix_file(maps.made("oc.csv", {"predict", maps.set, "--metric", "oc"}));
    REQUIRE(oc);
    const std::vector<double>& values = oc->dissimilarity.condensed;
    // Ranks of the printed digits, without rounding.
    for (const double a : values) {
        for (const double b : values) {
            const bool near = std::abs(a - b) <= 1e-10 * std::ranges::max(values);
            CHECK((a == b) == near);
        }
    }
    const Json one = Json::parse(output_of({"predict", maps.set, "--metric", "oc", "--json"}));
    CHECK(one.at("condensed").get<std::vector<double>>() == values);
}

TEST_CASE("findings --csv: a row a finding" * doctest::test_suite("long")) {
    const Maps maps;
    const Json all = Json::parse(output_of({"findings", "--json", "--csv", maps.at("f.csv")}));
    const std::string text = bytes_of(maps.at("f.csv"));
    CHECK(text.starts_with("id,set,claim,source,status,evidence\n"));
    for (const Json& one : all) CHECK(contains(text, "\n" + one.at("id").get<std::string>() + ","));
}

}  // namespace space_command_test
