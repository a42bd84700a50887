#include "model/io/set/model_json.h"

#include <nlohmann/json.hpp>

namespace tact {

namespace {

// Names of enumerators, in their order.
constexpr const char* kComponents[] = {"all", "peaks"};
constexpr const char* kSubthreshold[] = {"ignored", "subtracted"};
constexpr const char* kFireSharing[] = {"total", "own"};
constexpr const char* kWindowSplit[] = {"halves", "first"};
constexpr const char* kEnvelopeScale[] = {"normalised", "raw"};
constexpr const char* kEnvelopeAlignment[] = {"causal", "centred"};
constexpr const char* kSkinInput[] = {"displacement", "acceleration"};
constexpr const char* kReceptorNames[] = {"meissner", "pacinian", "merkel", "ruffini"};
static_assert(std::size(kReceptorNames) == kReceptorCount);

// One list for both directions: `visit` is called with the key, the field and what it may hold.
template <class Params, class Visit>
void visit_coding(Params& p, Visit&& visit) {
    visit("excitatory_layers", p.excitatory_layers, limits::kLayers);
    visit("inhibitory_layers", p.inhibitory_layers, limits::kLayers);
    visit("remove_mean", p.remove_mean);
    visit("skin_input", p.skin_input, kSkinInput);
    visit("components", p.components, kComponents);
    visit("peak_fraction", p.peak_fraction, limits::kShare);
    visit("subthreshold", p.subthreshold, kSubthreshold);
    visit("band_pass_order_per_edge", p.band_pass_order_per_edge, limits::kFilterOrder);
    visit("low_pass_order", p.low_pass_order, limits::kFilterOrder);
    visit("silent_energy_fraction", p.silent_energy_fraction, limits::kShare);
    visit("share", p.share, kFireSharing);
    visit("split", p.split, kWindowSplit);
    visit("excitatory", p.excitatory);
    visit("inhibitory", p.inhibitory);
    visit("spike_cap", p.spike_cap, limits::kSpikeCap);
    visit("tables", p.tables);
}

template <class Params, class Visit>
void visit_envelope(Params& p, Visit&& visit) {
    visit("scale", p.scale, kEnvelopeScale);
    visit("alignment", p.alignment, kEnvelopeAlignment);
    visit("waiting_cost", p.waiting_cost, limits::kWaitingCost);
}

template <class Params, class Visit>
void visit_model(Params& p, Visit&& visit) {
    visit("channel_weight", p.channel_weight);
    visit("nc_weight", p.nc_weight, limits::kWeight);
    visit("oc_weight", p.oc_weight, limits::kWeight);
}

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

// Takes fields out of an object.
struct TakeField {
    JsonObject* object;
    Json* unknown;

    void operator()(const char* key, int& value, Range range) const {
        value = whole_field(*object, key, value, range);
    }
    void operator()(const char* key, double& value, Range range) const {
        value = number_field(*object, key, value, range);
    }
    void operator()(const char* key, bool& value) const {
        value = yes_no_field(*object, key, value);
    }
    template <class Enum>
    void operator()(const char* key, Enum& value, std::span<const char* const> names) const {
        value =
            static_cast<Enum>(choice_field(*object, key, static_cast<std::size_t>(value), names));
    }
    void operator()(const char* key, CrossKernel& value) const {
        JsonObject kernel = object_field(*object, key);
        value.centre = number_field(kernel, "centre", value.centre, limits::kKernel);
        value.arm = number_field(kernel, "arm", value.arm, limits::kKernel);
        note_unknown(*unknown, key, unknown_fields(kernel));
    }
    void operator()(const char* key, PerReceptor<double>& value) const {
        JsonObject weights = object_field(*object, key);
        for (std::size_t c = 0; c < kReceptorCount; ++c) {
            value[c] = number_field(weights, kReceptorNames[c], value[c], limits::kWeight);
        }
        note_unknown(*unknown, key, unknown_fields(weights));
    }
    void operator()(const char* key, PhysiologyTables& value) const {
        JsonObject tables = object_field(*object, key);
        Json of_tables = Json::object();
        for (std::size_t c = 0; c < kReceptorCount; ++c) {
            JsonObject receptor = object_field(tables, kReceptorNames[c]);
            if (Curve slope = curve_field(receptor, "slope", kSlopeTable); !slope.value.empty()) {
                value.slope[c] = slope;
            }
            if (Curve threshold = curve_field(receptor, "threshold", kThresholdTable);
                !threshold.value.empty()) {
                value.threshold[c] = threshold;
            }
            note_unknown(of_tables, kReceptorNames[c], unknown_fields(receptor));
        }
        of_tables.update(unknown_fields(tables));
        note_unknown(*unknown, key, of_tables);
    }
};

// Puts fields into an object.
struct PutField {
    Json* object;

    void operator()(const char* key, int value, Range) const { (*object)[key] = value; }
    void operator()(const char* key, double value, Range) const { (*object)[key] = value; }
    void operator()(const char* key, bool value) const { (*object)[key] = value; }
    template <class Enum>
    void operator()(const char* key, Enum value, std::span<const char* const> names) const {
        (*object)[key] = names[static_cast<std::size_t>(value)];
    }
    void operator()(const char* key, const CrossKernel& value) const {
        (*object)[key] = {{"centre", value.centre}, {"arm", value.arm}};
    }
    void operator()(const char* key, const PerReceptor<double>& value) const {
        for (std::size_t c = 0; c < kReceptorCount; ++c) {
            (*object)[key][kReceptorNames[c]] = value[c];
        }
    }
    void operator()(const char* key, const PhysiologyTables& value) const {
        for (std::size_t c = 0; c < kReceptorCount; ++c) {
            (*object)[key][kReceptorNames[c]] = {{"slope", json_of(value.slope[c])},
                                                 {"threshold", json_of(value.threshold[c])}};
        }
    }
};

Json without_defaults(const Json& all, const Json& defaults) {
    Json different = Json::object();
    for (const auto& [key, value] : all.items()) {
        if (value != defaults.at(key)) different[key] = value;
    }
    return different;
}

struct WholeModel {
    Json coding = Json::object();
    Json envelope = Json::object();
    Json rest = Json::object();
};

WholeModel whole_model(const PerceptualModelParams& params) {
    WholeModel whole;
    visit_coding(params.coding, PutField{&whole.coding});
    visit_envelope(params.envelope, PutField{&whole.envelope});
    visit_model(params, PutField{&whole.rest});
    return whole;
}

}  // namespace

PerceptualModelParams model_of(JsonObject& object, Json& unknown) {
    PerceptualModelParams params;
    JsonObject coding = object_field(object, "coding");
    Json of_coding = Json::object();
    visit_coding(params.coding, TakeField{&coding, &of_coding});
    of_coding.update(unknown_fields(coding));
    JsonObject envelope = object_field(object, "envelope");
    Json of_envelope = Json::object();
    visit_envelope(params.envelope, TakeField{&envelope, &of_envelope});
    of_envelope.update(unknown_fields(envelope));
    visit_model(params, TakeField{&object, &unknown});
    note_unknown(unknown, "coding", of_coding);
    note_unknown(unknown, "envelope", of_envelope);
    unknown.update(unknown_fields(object));
    return params;
}

Json json_of(const PerceptualModelParams& params) {
    const WholeModel all = whole_model(params);
    const WholeModel defaults = whole_model({});
    Json model = Json::object();
    const Json coding = without_defaults(all.coding, defaults.coding);
    if (!coding.empty()) model["coding"] = coding;
    const Json envelope = without_defaults(all.envelope, defaults.envelope);
    if (!envelope.empty()) model["envelope"] = envelope;
    model.update(without_defaults(all.rest, defaults.rest));
    return model;
}

}  // namespace tact
