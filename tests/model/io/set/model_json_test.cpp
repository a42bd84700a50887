#include "model/io/set/model_json.h"

#include <doctest/doctest.h>

#include <nlohmann/json.hpp>

namespace model_json_test {

using namespace tact;

namespace {

PerceptualModelParams read(const Json& document, std::string* fault = nullptr) {
    JsonReading reading{"f.json", {}};
    JsonObject object = object_at(reading, document, "/model");
    Json unknown = Json::object();
    PerceptualModelParams params = model_of(object, unknown);
    if (fault != nullptr) *fault = reading.fault;
    if (fault == nullptr) CHECK(reading.fault == "");
    CHECK(unknown.empty());
    return params;
}

std::string fault(const char* text) {
    std::string message;
    read(Json::parse(text), &message);
    return message;
}

}  // namespace

TEST_CASE("model parameters: defaults are written as nothing and read from nothing") {
    CHECK(json_of(PerceptualModelParams{}).empty());
    CHECK(read(Json::object()) == PerceptualModelParams{});
}

TEST_CASE("model parameters: each one that differs survives, and alone") {
    std::vector<PerceptualModelParams> all(24);
    std::size_t k = 0;
    all[k++].coding.excitatory_layers = 0;
    all[k++].coding.inhibitory_layers = 4;
    all[k++].coding.remove_mean = false;
    all[k++].coding.skin_input = SkinInput::acceleration;
    all[k++].coding.components = Components::peaks;
    all[k++].coding.peak_fraction = 0.1;
    all[k++].coding.subthreshold = Subthreshold::subtracted;
    all[k++].coding.band_pass_order_per_edge = 10;
    all[k++].coding.low_pass_order = 2;
    all[k++].coding.silent_energy_fraction = 1e-9;
    all[k++].coding.share = FireSharing::own;
    all[k++].coding.split = WindowSplit::first;
    all[k++].coding.excitatory = {2.0, 1.0};
    all[k++].coding.inhibitory = {4.0, -1.0};
    all[k++].coding.inhibitory.arm = -0.25;
    all[k++].coding.spike_cap = 25;
    all[k++].coding.tables.slope[index_of(Receptor::merkel)].value[0] = 1.0 / 3.0;
    all[k++].coding.tables.threshold[index_of(Receptor::pacinian)] = {{40.0, 250.0}, {1.0, -1.0}};
    all[k++].envelope.scale = EnvelopeScale::raw;
    all[k++].envelope.alignment = EnvelopeAlignment::centred;
    all[k++].channel_weight[3] = 0.0;
    all[k++].nc_weight = 0.3;
    all[k++].oc_weight = 0.0;
    REQUIRE(k + 1 == all.size());
    for (std::size_t j = 0; j < k; ++j) {
        CAPTURE(j);
        CHECK(all[j] != PerceptualModelParams{});
        const Json document = json_of(all[j]);
        CHECK(document.size() == 1);
        CHECK(read(document) == all[j]);
        CHECK(read(Json::parse(document.dump())) == all[j]);
    }
}

TEST_CASE("model parameters: names are those of the source") {
    PerceptualModelParams params;
    params.coding.excitatory_layers = 2;
    params.coding.share = FireSharing::own;
    params.envelope.scale = EnvelopeScale::raw;
    params.channel_weight = {0.5, 0.25, 0.125, 1.0};
    CHECK(json_of(params).dump() ==
          R"({"coding":{"excitatory_layers":2,"share":"own"},"envelope":{"scale":"raw"},)"
          R"("channel_weight":{"meissner":0.5,"pacinian":0.25,"merkel":0.125,"ruffini":1.0}})");
}

TEST_CASE("model parameters: what they cannot be is refused with its place") {
    CHECK(fault(R"({"coding": {"excitatory_layers": 2.5}})") ==
          "f.json: /model/coding/excitatory_layers: expected a whole number from 0 to 16, got 2.5");
    CHECK(fault(R"({"coding": {"share": "equal"}})") ==
          "f.json: /model/coding/share: expected \"total\" or \"own\", got \"equal\"");
    CHECK(fault(R"({"channel_weight": {"merkel": -1}})") ==
          "f.json: /model/channel_weight/merkel: expected a number from 0 to 1000, got -1");
    const auto tables = [](const std::string& slope) {
        return fault((R"({"coding": {"tables": {"meissner": {"slope": )" + slope + "}}}}").c_str());
    };
    const std::string place = "f.json: /model/coding/tables/meissner/slope";
    CHECK(tables("[]") == place + ": expected an array of 1 to 10000, got an array of 0");
    CHECK(tables("[[1, 2], [3]]") ==
          place + "/1: expected a pair [frequency_hz, value], got an array of 1");
    CHECK(tables("[[10, 2], [10, 3]]") ==
          place + "/1/0: expected frequencies above 0 that ascend, got 10");
    CHECK(tables("[[1, 1e308]]") ==
          place + "/0/1: expected impulses/s per log10 um from 0 to 10000, got 1e+308");
    CHECK(tables("[[1, -1]]").find("/0/1: expected impulses/s") != std::string::npos);
    CHECK(fault(R"({"coding": {"tables": {"pacinian": {"threshold": [[250, -20]]}}}})") ==
          "f.json: /model/coding/tables/pacinian/threshold/0/1: expected log10 of um peak from -4 "
          "to 6 (beyond them it looks like dB, which are 20 times that), got -20");
    CHECK(tables("[[0, 2]]") == place + "/0/0: expected frequencies above 0 that ascend, got 0");
    CHECK(tables("[[1, \"x\"]]") == place + "/0/1: expected a number, got \"x\"");
    CHECK(tables("[[1, 2]]").empty());
}

}  // namespace model_json_test
