// What a file of model parameters holds, and a physiologist's tables, is what is kept of it: over
// random parameters, and over files after accidents.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <sstream>

#include "model/io/set/model_file.h"
#include "model/text/numbers.h"
#include "tests/support/misspelt_keys.h"
#include "tests/support/mutations.h"
#include "tests/support/temporary_folder.h"

namespace every_model_test {

using namespace tact;

namespace {

double within(std::mt19937& random, Range range) {
    const std::size_t which = any_below(random, 6);
    if (which == 0) return range.low;
    if (which == 1) return range.high;
    const double share = static_cast<double>(random()) / 4294967295.0;
    return std::clamp(std::lerp(range.low, range.high, share), range.low, range.high);
}

int whole(std::mt19937& random, Range range) {
    return static_cast<int>(std::floor(within(random, range)));
}

template <class Enum>
Enum one_of_two(std::mt19937& random) {
    return static_cast<Enum>(any_below(random, 2));
}

Curve curve(std::mt19937& random, Range values) {
    Curve curve;
    double f_hz = 1e-3;
    for (std::size_t k = 0, count = 1 + any_below(random, 5); k < count; ++k) {
        f_hz *= 1.0 + within(random, {0.01, 50.0});
        curve.frequency_hz.push_back(f_hz);
        curve.value.push_back(within(random, values));
    }
    return curve;
}

PhysiologyTables tables(std::mt19937& random) {
    PhysiologyTables tables;
    for (std::size_t c = 0; c < kReceptorCount; ++c) {
        tables.slope[c] = curve(random, kSlopeTable.values);
        tables.threshold[c] = curve(random, kThresholdTable.values);
    }
    return tables;
}

PerceptualModelParams any_params(std::mt19937& random) {
    PerceptualModelParams params;
    NeuralCodingParams& coding = params.coding;
    coding.excitatory_layers = whole(random, limits::kLayers);
    coding.inhibitory_layers = whole(random, limits::kLayers);
    coding.remove_mean = any_below(random, 2) == 0;
    coding.skin_input = one_of_two<SkinInput>(random);
    coding.components = one_of_two<Components>(random);
    coding.peak_fraction = within(random, limits::kShare);
    coding.subthreshold = one_of_two<Subthreshold>(random);
    coding.band_pass_order_per_edge = whole(random, limits::kFilterOrder);
    coding.low_pass_order = whole(random, limits::kFilterOrder);
    coding.silent_energy_fraction = within(random, limits::kShare);
    coding.share = one_of_two<FireSharing>(random);
    coding.split = one_of_two<WindowSplit>(random);
    coding.excitatory = {within(random, limits::kKernel), within(random, limits::kKernel)};
    coding.inhibitory = {within(random, limits::kKernel), within(random, limits::kKernel)};
    coding.spike_cap = whole(random, limits::kSpikeCap);
    if (any_below(random, 2) == 0) coding.tables = tables(random);
    params.envelope.scale = one_of_two<EnvelopeScale>(random);
    params.envelope.alignment = one_of_two<EnvelopeAlignment>(random);
    for (double& weight : params.channel_weight) weight = within(random, limits::kWeight);
    params.nc_weight = within(random, limits::kWeight);
    params.oc_weight = within(random, limits::kWeight);
    return params;
}

ModelFile any_file(std::mt19937& random) {
    ModelFile file{any_params(random), {}};
    if (any_below(random, 3) == 0) return file;
    TrainingRecord record;
    record.program = "tactspace \"0\"";
    record.date = "2026-11-21T16:00:00Z";
    record.objective = one_of_two<TrainingObjective>(random);
    record.step = within(random, {1e-6, 1.0});
    record.value = any_below(random, 4) == 0 ? std::nan("") : within(random, {-1.0, 1.0});
    record.value_before = within(random, {-1.0, 1.0});
    record.equally_good = any_below(random, 1'000'000);
    for (std::size_t k = any_below(random, 4); k > 0; --k) {
        record.sets.push_back({"\u00e9 \\ \"" + std::to_string(k), "0123456789abcdef",
                               any_below(random, 500), any_below(random, 100'000),
                               any_below(random, 30), within(random, {-1.0, 1.0}), std::nan(""),
                               any_below(random, 2) == 0});
    }
    file.training = record;
    return file;
}

// NaN is no number that equals itself: what is printed tells two files apart as well.
void check_kept(const ModelFile& file) {
    const std::string text = print_model(file);
    const auto again = parse_model(text, "again.json");
    REQUIRE_MESSAGE(again, (again ? "" : again.error().message));
    CHECK(again->model == file.model);
    CHECK(again->training.has_value() == file.training.has_value());
    CHECK(print_model(*again) == text);
}

std::string csv_of(const PerReceptor<Curve>& curves, const char* column) {
    std::string csv = std::string("receptor,frequency_hz,") + column + "\n";
    for (const Receptor receptor : kReceptors) {
        const Curve& curve = curves[index_of(receptor)];
        for (std::size_t k = 0; k < curve.value.size(); ++k) {
            csv += std::string(traits(receptor).afferent) + "," +
                   shortest_digits(curve.frequency_hz[k]) + "," + shortest_digits(curve.value[k]) +
                   "\n";
        }
    }
    return csv;
}

}  // namespace

TEST_CASE("every model: whatever parameters there can be are written, and read as they were") {
    for (unsigned seed = 0; seed < 300; ++seed) {
        CAPTURE(seed);
        std::mt19937 random(seed);
        check_kept(any_file(random));
    }
}

TEST_CASE(
    "every model: a misspelt parameter is refused by its name, not taken for the published one") {
    const auto fault_of = [](const std::string& text) {
        const auto file = parse_model(text, "m.json");
        return file ? std::string() : file.error().message;
    };
    std::mt19937 random(1);
    ModelFile file = any_file(random);
    while (!file.training || file.training->sets.empty()) file = any_file(random);
    check_misspelt_keys_refused(print_model(file), fault_of);
    CHECK(fault_of(R"({"tactspace_model": 1, "model": {"colour": 1}})") ==
          "m.json: /model: does not know \"colour\"");
}

TEST_CASE("every model: a file after an accident is refused, or kept as it was read") {
    std::size_t accepted = 0;
    for (unsigned seed = 0; seed < 600; ++seed) {
        CAPTURE(seed);
        std::mt19937 random(seed);
        const auto file =
            parse_model(after_mishaps(print_model(any_file(random)), random), "m.json");
        if (!file) {
            CHECK(contains(file.error().message, "m.json"));
            CHECK_FALSE(contains(file.error().message, "\n"));
            continue;
        }
        ++accepted;
        check_kept(*file);
    }
    CHECK(accepted > 20);
}

TEST_CASE(
    "every model: tables, and tables after an accident, are refused or kept as they were read") {
    std::size_t accepted = 0;
    for (unsigned seed = 0; seed < 1200; ++seed) {
        CAPTURE(seed);
        std::mt19937 random(seed);
        const PhysiologyTables drawn = tables(random);
        const bool is_slope = seed % 2 == 0;
        const TableTraits& table = is_slope ? kSlopeTable : kThresholdTable;
        const auto parse = is_slope ? parse_slopes : parse_thresholds;
        const std::string whole = csv_of(is_slope ? drawn.slope : drawn.threshold, table.column);
        CHECK(*parse(whole) == (is_slope ? drawn.slope : drawn.threshold));
        const auto curves = parse(after_mishaps(whole, random));
        if (!curves) {
            CHECK(contains(curves.error().message, table.name));
            CHECK_FALSE(contains(curves.error().message, "\n"));
            continue;
        }
        ++accepted;
        CHECK(*parse(csv_of(*curves, table.column)) == *curves);
        ModelFile file;
        (is_slope ? file.model.coding.tables.slope : file.model.coding.tables.threshold) = *curves;
        check_kept(file);
    }
    CHECK(accepted > 100);
}

}  // namespace every_model_test
