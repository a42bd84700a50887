#include "model/io/set/design_space_json.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "model/pattern/pattern_numbers.h"

namespace tact {

namespace {

constexpr const char* kDesigns[] = {"factorial", "latin-hypercube", "sobol"};
constexpr const char* kSpacings[] = {"linear", "log"};

Span span_of(JsonReading& reading, const Json& value, const std::string& place, Range allowed,
             Json& unknown) {
    JsonObject fields = object_at(reading, value, place);
    Span span;
    for (const char* key : {"from", "to"}) {
        if (!value.contains(key)) refuse(reading, place, "a range with \"from\" and \"to\"", value);
    }
    span.from = number_field(fields, "from", allowed.low, allowed);
    span.to = number_field(fields, "to", allowed.high, allowed);
    if (span.to < span.from) {
        refuse(reading, place + "/to", "a number not below \"from\"", span.to);
    }
    span.steps = whole_field(fields, "steps", span.steps, limits::kSpanSteps);
    span.logarithmic = choice_field(fields, "spacing", 0, kSpacings) == 1;
    if (span.logarithmic && span.from <= 0.0) {
        refuse(reading, place + "/from", "a number above 0 for the spacing \"log\"", span.from);
    }
    span.multiple_of = number_field(fields, "multiple_of", 0.0, limits::kMultiple);
    unknown = unknown_fields(fields);
    return span;
}

Values values_field(JsonObject& object, const char* key, const Values& fallback, Range allowed,
                    Json& unknown) {
    const Json* value = field(object, key);
    if (value == nullptr) return fallback;
    JsonReading& reading = *object.reading;
    const std::string place = place_of(object, key);
    if (value->is_number()) return fixed(number_at(reading, *value, place, allowed));
    if (value->is_object()) {
        Json of_span = Json::object();
        const Span span = span_of(reading, *value, place, allowed, of_span);
        note_unknown(unknown, key, of_span);
        return span;
    }
    if (!value->is_array()) {
        refuse(reading, place, "a number, an array of levels or a range with \"from\" and \"to\"",
               *value);
        return fallback;
    }
    std::vector<double> levels;
    const auto elements = array_field(object, key, 1, limits::kMaxLevels);
    for (std::size_t k = 0; k < elements.size(); ++k) {
        levels.push_back(
            number_at(reading, *elements[k], place + "/" + std::to_string(k), allowed));
    }
    return levels.empty() ? fallback : Values(std::move(levels));
}

// Values of a number, each within what a pattern may have of it.
void take_values(JsonObject& object, const Number& number, Values& values, Json& unknown) {
    values = values_field(object, number.key, values, number.range, unknown);
}

std::vector<CarrierValues> carrier_values_of(JsonObject& object, Json& unknown) {
    std::vector<CarrierValues> carriers;
    read_objects(object, "carriers", 1, limits::kMaxCarriers, unknown,
                 [&](JsonObject& one, Json& of_one) {
                     CarrierValues& carrier = carriers.emplace_back();
                     take_values(one, numbers::kCarrier, carrier.frequency_hz, of_one);
                     take_values(one, numbers::kWeight, carrier.weight, of_one);
                 });
    return carriers.empty() ? std::vector<CarrierValues>(1) : carriers;
}

void read_modulation(JsonObject& object, DesignSpace& space, Json& unknown) {
    JsonObject fields = object_field(object, "modulation");
    Json of_modulation = Json::object();
    const auto kinds = array_field(fields, "kinds", 1, kModulationKinds.size());
    if (!kinds.empty()) space.kinds.clear();
    for (std::size_t k = 0; k < kinds.size(); ++k) {
        const auto known = std::ranges::find_if(kModulationKinds, [&](const char* kind) {
            return kinds[k]->is_string() && kinds[k]->get<std::string>() == kind;
        });
        if (known == kModulationKinds.end()) {
            refuse(*object.reading, place_of(fields, "kinds") + "/" + std::to_string(k),
                   "\"product\" or \"am\"", *kinds[k]);
            continue;
        }
        space.kinds.push_back(static_cast<ModulationKind>(known - kModulationKinds.begin()));
    }
    take_values(fields, numbers::kModulation, space.modulation_hz, of_modulation);
    take_values(fields, numbers::kDepth, space.depth, of_modulation);
    of_modulation.update(unknown_fields(fields));
    note_unknown(unknown, "modulation", of_modulation);
}

void read_rhythms(JsonObject& object, DesignSpace& space, Json& unknown) {
    JsonObject fields = object_field(object, "rhythm");
    Json of_rhythm = Json::object();
    const auto texts = array_field(fields, "texts", 1, limits::kMaxLevels);
    if (!texts.empty()) space.rhythms.clear();
    for (std::size_t k = 0; k < texts.size(); ++k) {
        const std::string text = texts[k]->is_string() ? texts[k]->get<std::string>() : "?";
        const std::string fault = rhythm_fault(text);
        if (!fault.empty()) {
            refuse(*object.reading, place_of(fields, "texts") + "/" + std::to_string(k),
                   "a rhythm (" + fault + ")", *texts[k]);
        }
        space.rhythms.push_back(fault.empty() ? text : "");
    }
    take_values(fields, numbers::kRhythmUnit, space.unit_s, of_rhythm);
    of_rhythm.update(unknown_fields(fields));
    note_unknown(unknown, "rhythm", of_rhythm);
}

std::optional<double> limit_field(JsonObject& object, const char* key, Range allowed) {
    if (object.value == nullptr || !object.value->contains(key)) return std::nullopt;
    return number_field(object, key, 0.0, allowed);
}

Constraints constraints_of(JsonObject& object, Json& unknown) {
    JsonObject fields = object_field(object, "constraints");
    JsonReading& reading = *object.reading;
    Constraints constraints;
    const auto band = array_field(fields, "band_hz", 2, 2);
    if (band.size() == 2) {
        const std::string place = place_of(fields, "band_hz");
        const double low = number_at(reading, *band[0], place + "/0", limits::kBandHz);
        const double high = number_at(reading, *band[1], place + "/1", limits::kBandHz);
        if (high < low) refuse(reading, place + "/1", "a number not below the first", *band[1]);
        constraints.band_hz = Range{low, high};
    }
    constraints.displacement_um = limit_field(fields, "displacement_um", limits::kDisplacementUm);
    constexpr double kUmPerMm = 1000.0;
    const auto most_mm =
        limit_field(fields, "displacement_mm", {0.0, limits::kDisplacementUm.high / kUmPerMm});
    if (most_mm && constraints.displacement_um) {
        refuse(reading, place_of(fields, "displacement_mm"),
               "one limit, in \"displacement_um\" or in \"displacement_mm\"",
               fields.value->at("displacement_mm"));
    }
    if (most_mm) constraints.displacement_um = kUmPerMm * *most_mm;
    constraints.detectable_db = limit_field(fields, "detectable_db", limits::kDetectableDb);
    note_unknown(unknown, "constraints", unknown_fields(fields));
    return constraints;
}

Json json_of(const Values& values) {
    if (const auto* levels = std::get_if<std::vector<double>>(&values)) {
        return levels->size() == 1 ? Json(levels->front()) : Json(*levels);
    }
    const Span& span = std::get<Span>(values);
    Json fields = {{"from", span.from}, {"to", span.to}, {"steps", span.steps}};
    if (span.logarithmic) fields["spacing"] = "log";
    if (span.multiple_of > 0.0) fields["multiple_of"] = span.multiple_of;
    return fields;
}

void put(Json& fields, const Number& number, const Values& values, const Values& fallback) {
    if (values != fallback) fields[number.key] = json_of(values);
}

Json json_of(const Constraints& constraints) {
    Json fields = Json::object();
    if (constraints.band_hz) {
        fields["band_hz"] = {constraints.band_hz->low, constraints.band_hz->high};
    }
    if (constraints.displacement_um) fields["displacement_um"] = *constraints.displacement_um;
    if (constraints.detectable_db) fields["detectable_db"] = *constraints.detectable_db;
    return fields;
}

Json carriers_json(const DesignSpace& space) {
    Json carriers = Json::array();
    for (const CarrierValues& carrier : space.carriers) {
        Json fields = {{"frequency_hz", json_of(carrier.frequency_hz)}};
        put(fields, numbers::kWeight, carrier.weight, CarrierValues{}.weight);
        carriers.push_back(fields);
    }
    return carriers;
}

Json modulation_json(const DesignSpace& space, const DesignSpace& defaults) {
    Json fields = Json::object();
    if (space.kinds != defaults.kinds) {
        fields["kinds"] = Json::array();
        for (const ModulationKind kind : space.kinds) {
            fields["kinds"].push_back(kModulationKinds[static_cast<std::size_t>(kind)]);
        }
    }
    put(fields, numbers::kModulation, space.modulation_hz, defaults.modulation_hz);
    put(fields, numbers::kDepth, space.depth, defaults.depth);
    return fields;
}

}  // namespace

DesignSpace design_space_of(JsonObject& object, double set_duration_s, Json& unknown) {
    DesignSpace space;
    space.design = static_cast<Design>(choice_field(object, "design", 0, kDesigns));
    space.samples = whole_field(object, "samples", space.samples, limits::kSamples);
    space.seed = whole_field(object, "seed", space.seed, limits::kSeed);
    take_values(object, numbers::kAmplitude, space.amplitude_g, unknown);
    space.carriers = carrier_values_of(object, unknown);
    if (const Json* mix = field(object, "mix")) {
        space.mix = values_field(object, "mix", fixed(0.5), limits::kMix, unknown);
        if (space.carriers.size() != 2) {
            refuse(*object.reading, place_of(object, "mix"), "two carriers to mix", *mix);
        }
    }
    read_modulation(object, space, unknown);
    read_rhythms(object, space, unknown);
    space.duration_s = fixed(set_duration_s);
    take_values(object, numbers::kAttack, space.attack_s, unknown);
    take_values(object, numbers::kRelease, space.release_s, unknown);
    take_values(object, numbers::kDuration, space.duration_s, unknown);
    space.constraints = constraints_of(object, unknown);
    unknown.update(unknown_fields(object));
    return space;
}

Json json_of(const DesignSpace& space, double set_duration_s) {
    const DesignSpace defaults;
    Json fields = {{"design", kDesigns[static_cast<std::size_t>(space.design)]}};
    if (space.samples != defaults.samples) fields["samples"] = space.samples;
    if (space.seed != defaults.seed) fields["seed"] = space.seed;
    put(fields, numbers::kAmplitude, space.amplitude_g, defaults.amplitude_g);
    fields["carriers"] = carriers_json(space);
    if (space.mix) fields["mix"] = json_of(*space.mix);
    note_unknown(fields, "modulation", modulation_json(space, defaults));
    Json rhythm = Json::object();
    if (space.rhythms != defaults.rhythms) rhythm["texts"] = space.rhythms;
    put(rhythm, numbers::kRhythmUnit, space.unit_s, defaults.unit_s);
    note_unknown(fields, "rhythm", rhythm);
    put(fields, numbers::kAttack, space.attack_s, defaults.attack_s);
    put(fields, numbers::kRelease, space.release_s, defaults.release_s);
    put(fields, numbers::kDuration, space.duration_s, fixed(set_duration_s));
    note_unknown(fields, "constraints", json_of(space.constraints));
    return fields;
}

}  // namespace tact
