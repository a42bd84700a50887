#include "model/io/set/model_json.h"

#include "model/perceptual_model/model_numbers.h"
#include "model/text/described_json.h"

namespace tact {

namespace {

// [[f_hz, value], ...] with ascending frequencies.
Curve curve_field(JsonObject& object, std::string_view key, const TableTraits& table) {
    constexpr std::size_t kMaxKnots = 10'000;
    Curve curve;
    JsonReading& reading = *object.reading;
    const std::string place = place_of(object, key);
    const auto knots = array_field(object, key, 1, kMaxKnots);
    for (std::size_t k = 0; k < knots.size(); ++k) {
        const std::string knot_place = place + "/" + std::to_string(k);
        if (!knots[k]->is_array() || knots[k]->size() != 2) {
            refuse(reading, knot_place, "a pair [frequency_hz, value]", *knots[k]);
            return curve;
        }
        const double frequency_hz =
            number_at(reading, (*knots[k])[0], knot_place + "/0", kAnyNumber);
        if (frequency_hz <= (k == 0 ? 0.0 : curve.frequency_hz.back())) {
            refuse(reading, knot_place + "/0", "frequencies above 0 that ascend", (*knots[k])[0]);
        }
        curve.frequency_hz.push_back(frequency_hz);
        const Json& written = (*knots[k])[1];
        curve.value.push_back(number_at(reading, written, knot_place + "/1", kAnyNumber));
        if (!table.values.contains(curve.value.back())) {
            refuse(reading, knot_place + "/1", table.expected, written);
        }
    }
    return curve;
}

Json json_of(const Curve& curve) {
    Json knots = Json::array();
    for (std::size_t k = 0; k < curve.value.size(); ++k) {
        knots.push_back({curve.frequency_hz[k], curve.value[k]});
    }
    return knots;
}

}  // namespace

void take_fields(JsonObject& object, PhysiologyTables& tables, Json& unknown) {
    for (std::size_t c = 0; c < kReceptorCount; ++c) {
        const char* name = numbers::kChannelWeights[c].key;
        JsonObject receptor = object_field(object, name);
        if (Curve slope = curve_field(receptor, "slope", kSlopeTable); !slope.value.empty()) {
            tables.slope[c] = slope;
        }
        if (Curve threshold = curve_field(receptor, "threshold", kThresholdTable);
            !threshold.value.empty()) {
            tables.threshold[c] = threshold;
        }
        note_unknown(unknown, name, unknown_fields(receptor));
    }
}

void put_fields(Json& object, const PhysiologyTables& tables, const PhysiologyTables*) {
    for (std::size_t c = 0; c < kReceptorCount; ++c) {
        object[numbers::kChannelWeights[c].key] = {{"slope", json_of(tables.slope[c])},
                                                   {"threshold", json_of(tables.threshold[c])}};
    }
}

PerceptualModelParams model_of(JsonObject& object, Json& unknown) {
    PerceptualModelParams params;
    take_fields(object, params, unknown);
    unknown.update(unknown_fields(object));
    return params;
}

Json json_of(const PerceptualModelParams& params) {
    const PerceptualModelParams defaults;
    Json model = Json::object();
    put_fields(model, params, &defaults);
    return model;
}

}  // namespace tact
