#include "model/io/set/model_file.h"

#include <doctest/doctest.h>

#include <cmath>

#include "tests/support/temporary_folder.h"

namespace model_file_test {

using namespace tact;

namespace {

ModelFile trained() {
    ModelFile file;
    file.model.coding.excitatory_layers = 2;
    file.model.channel_weight = {0.1, 0.2, 0.3, 1.0};
    file.model.nc_weight = 0.7;
    file.training = TrainingRecord{"tactspace 0.1.0",
                                   "2026-11-21T16:00:00Z",
                                   TrainingObjective::mean_absolute_rho,
                                   0.1,
                                   0.7125,
                                   0.5,
                                   12,
                                   {{"twelve \"ü\"", "0123456789abcdef", 12, 66, 20, 0.4, 0.6}}};
    return file;
}

std::string fault(const std::string& text) {
    const auto file = parse_model(text, "p.json");
    return file ? std::string() : file.error().message;
}

}  // namespace

TEST_CASE("model file: what is written is read, provenance and all") {
    const TemporaryFolder folder;
    const auto path = folder.path / "params.json";
    REQUIRE(write_model_file(path, trained()));
    const auto read = read_model_file(path);
    REQUIRE(read);
    CHECK(*read == trained());
}

TEST_CASE("model file: that nobody was asked is written, read, and said") {
    ModelFile file = trained();
    CHECK(remark_on_synthetic(file).empty());
    CHECK_FALSE(contains(print_model(file), "synthetic"));
    file.training->sets[0].mark.synthetic = true;
    const auto read = parse_model(print_model(file), "p.json");
    REQUIRE(read);
    CHECK(*read == file);
    CHECK(remark_on_synthetic(*read) == "trained on synthetic ratings: nobody was asked");
}

TEST_CASE("model file: an undefined rho stays undefined") {
    ModelFile file = trained();
    file.training->sets[0].rho_before = std::nan("");
    const auto read = parse_model(print_model(file), "p.json");
    REQUIRE(read);
    CHECK(std::isnan(read->training->sets[0].rho_before));
}

TEST_CASE("model file: parameters written by hand need no provenance") {
    const auto read =
        parse_model(R"({"tactspace_model": 1, "model": {"nc_weight": 0.3}})", "p.json");
    REQUIRE(read);
    CHECK(read->model.nc_weight == 0.3);
    CHECK_FALSE(read->training);
}

TEST_CASE("model file: what is no such file is refused with its place") {
    CHECK(fault("{}") == "p.json: is no file of model parameters, expected \"tactspace_model\": 1");
    CHECK(fault(R"({"tactspace_model": 2})") ==
          "p.json: made by a newer version (format 2, this one reads 1)");
    CHECK(fault(R"({"tactspace_model": 1, "model": {"nc_weight": -1}})").find("nc_weight") !=
          std::string::npos);
    CHECK(fault(R"({"tactspace_model": 1, "training": {"objective": "rho"}})").find("objective") !=
          std::string::npos);
    CHECK(fault("[1]") != "");
    CHECK(fault("{") != "");
}

TEST_CASE("model file: sets are told apart by their waveforms and by what people said") {
    TrainingSet set{"a", {Waveform{10'000.0, {0.1, 0.2}}}, {{"x"}, true, {{"P", {1.0}}}}};
    const std::string before = fingerprint_of(set);
    CHECK(before.size() == 16);
    TrainingSet renamed = set;
    renamed.name = "b";
    CHECK(fingerprint_of(renamed) == before);
    TrainingSet louder = set;
    louder.waveforms[0].samples_g[1] = 0.3;
    CHECK(fingerprint_of(louder) != before);
    TrainingSet other = set;
    other.study.judgements[0].condensed[0] = 2.0;
    CHECK(fingerprint_of(other) != before);
}

}  // namespace model_file_test
