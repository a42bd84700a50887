#include "model/io/set/set_json.h"

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>

#include "model/dissimilarity/dissimilarity.h"
#include "model/io/folders/percent_code.h"
#include "model/io/set/design_space_json.h"
#include "model/io/set/model_json.h"
#include "model/io/set/study_json.h"
#include "model/set/layers.h"
#include "model/text/json_fields.h"
#include "model/text/names.h"
#include "model/text/numbers.h"
#include "model/text/utf8.h"
#include "model/told_apart/told_apart_document.h"

namespace tact {

namespace fs = std::filesystem;

namespace {

// As many as files of ratings can bring together; what they need is bounded by their memory.
constexpr std::size_t kMaxRatings = 100'000;

// Text of unknown fields as a value of the set keeps them: empty without any.
std::string kept_text(const Json& unknown) {
    return unknown.empty() ? std::string() : text_of_json(unknown);
}

void restore_text(Json& document, const std::string& unknown_json) {
    const Json unknown = kept_json(unknown_json);
    if (unknown.is_object()) restore_unknown(document, unknown);
}

Measurement measurement_of(JsonObject& object) {
    Measurement measurement;
    measurement.path = text_field(object, "waveform", "");
    if (measurement.path.empty()) {
        refuse(*object.reading, place_of(object, "waveform"), "the path of a file",
               *field(object, "waveform"));
    }
    if (yes_no_field(object, "percent_encoded", false)) {
        const auto bytes = percent_decoded(measurement.path);
        if (!bytes) {
            refuse(*object.reading, place_of(object, "waveform"), "two digits behind each %",
                   *field(object, "waveform"));
        }
        measurement.path = bytes.value_or("");
    }
    measurement.scale_g = number_field(object, "scale_g", 0.0, limits::kScaleG);
    measurement.measures = name_field(object, "measures", "");
    measurement.synthetic = yes_no_field(object, "synthetic", false);
    measurement.measures_version = text_field(object, "measures_version", "");
    return measurement;
}

std::string colour_of(JsonObject& object) {
    std::string colour = text_field(object, "colour", "");
    const bool is_colour = colour.size() == 7 && colour[0] == '#' &&
                           colour.find_first_not_of("0123456789abcdefABCDEF", 1) == colour.npos;
    if (!colour.empty() && !is_colour) {
        refuse(*object.reading, place_of(object, "colour"), "a colour as #RRGGBB", colour);
    }
    return colour;
}

bool ring_of(JsonObject& object) {
    const std::string mark = text_field(object, "mark", "disc");
    if (mark != "disc" && mark != "ring") {
        refuse(*object.reading, place_of(object, "mark"), "\"disc\" or \"ring\"", mark);
    }
    return mark == "ring";
}

EffectOrigin effect_of(JsonObject& object, Json& unknown) {
    JsonObject fields = object_field(object, "effect");
    EffectOrigin effect{name_field(fields, "format", ""), name_field(fields, "actuator", "")};
    note_unknown(unknown, "effect", unknown_fields(fields));
    return effect;
}

bool has_key(const JsonObject& object, const char* key) {
    return object.value != nullptr && object.value->contains(key);
}

Layer layer_of(JsonObject& object, double set_duration_s, Json& unknown) {
    Layer layer;
    layer.name = name_field(object, "name", "");
    if (has_key(object, "waveform")) {
        layer.source = measurement_of(object);
    } else {
        layer.source = pattern_of(object, set_duration_s, unknown);
    }
    layer.gain = number_field(object, "gain", layer.gain, limits::kLayerGain);
    layer.offset_s = number_field(object, "offset_s", layer.offset_s, limits::kLayerOffsetS);
    layer.mute = yes_no_field(object, "mute", false);
    layer.solo = yes_no_field(object, "solo", false);
    return layer;
}

Vibration vibration_of(JsonObject& object, double set_duration_s) {
    Vibration vibration;
    Json unknown = Json::object();
    vibration.name = name_field(object, "name", "");
    if (has_key(object, "layers")) {
        vibration.source = layered_of(object, set_duration_s, unknown);
    } else if (has_key(object, "waveform")) {
        vibration.source = measurement_of(object);
    } else {
        vibration.source = pattern_of(object, set_duration_s, unknown);
    }
    vibration.locked = yes_no_field(object, "locked", false);
    vibration.dropped = yes_no_field(object, "dropped", false);
    if (vibration.locked && vibration.dropped) {
        refuse(*object.reading, place_of(object, "dropped"), "false for a locked pattern",
               *field(object, "dropped"));
    }
    vibration.colour = colour_of(object);
    vibration.ring = ring_of(object);
    vibration.note = text_field(object, "note", "");
    vibration.generated = yes_no_field(object, "generated", false);
    vibration.effect = effect_of(object, unknown);
    unknown.update(unknown_fields(object));
    vibration.unknown_json = kept_text(unknown);
    return vibration;
}

void refuse_equal_names(JsonReading& reading, const std::vector<std::string>& names,
                        const std::string& array, const std::string& key) {
    const auto equal = first_equal(names);
    if (!equal || !reading.fault.empty()) return;
    reading.fault = reading.file + ": " + array + "/" + std::to_string(equal->second) + key + ": " +
                    in_quotes(names[equal->second]) + " is the name of " + array + "/" +
                    std::to_string(equal->first) + " too, expected names that differ";
}

void read_vibrations(JsonObject& object, PatternSet& set, std::vector<std::string>& remarks) {
    const auto elements = array_field(object, "patterns", 0, limits::kMaxPatterns);
    std::vector<std::string> names;
    for (std::size_t k = 0; k < elements.size() && may_go_on(*object.reading); ++k) {
        JsonObject fields = object_at(*object.reading, *elements[k],
                                      place_of(object, "patterns") + "/" + std::to_string(k));
        Vibration vibration = vibration_of(fields, set.duration_s);
        if (vibration.name.empty()) {
            vibration.name = "pattern " + std::to_string(k + 1);
            remarks.push_back(object.reading->file + ": " + fields.place +
                              " has no name and is called " + in_quotes(vibration.name));
        }
        names.push_back(vibration.name);
        set.vibrations.push_back(std::move(vibration));
    }
    refuse_equal_names(*object.reading, names, "/patterns", "/name");
}

// One for each label, or none at all.
std::vector<std::string> versions_of(JsonObject& object, std::size_t labels) {
    std::vector<std::string> versions;
    JsonReading& reading = *object.reading;
    for (const Json* version : array_field(object, "versions", 0, limits::kMaxPatterns)) {
        versions.push_back(name_at(reading, *version, place_of(object, "versions")));
    }
    if (!versions.empty() && versions.size() != labels && reading.fault.empty()) {
        reading.fault = reading.file + ": " + place_of(object, "versions") +
                        ": expected a version for each of " + grouped_digits(labels) +
                        " labels, got " + grouped_digits(versions.size());
    }
    return versions;
}

// Files of before November 2026 say in the name of the ratings' file that nobody was asked.
NumberMark rating_mark_in(JsonObject& object, std::string& file) {
    constexpr std::string_view kEarlier = "synthetic, ";
    const bool is_earlier = file.starts_with(kEarlier);
    if (is_earlier) file.erase(0, kEarlier.size());
    const auto count = [&object](const char* key) {
        return static_cast<std::size_t>(number_field(object, key, 0.0, {0.0, 1e6}));
    };
    return {.synthetic = yes_no_field(object, "synthetic", false) || is_earlier,
            .left_out = count("left_out"),
            .rehearsals = count("rehearsals")};
}

Ratings ratings_of(JsonObject& object) {
    Ratings ratings;
    ratings.name = name_field(object, "name", "");
    JsonReading& reading = *object.reading;
    const auto labels = array_field(object, "labels", 0, limits::kMaxPatterns);
    for (std::size_t k = 0; k < labels.size(); ++k) {
        const std::string place = place_of(object, "labels") + "/" + std::to_string(k);
        ratings.labels.push_back(name_at(reading, *labels[k], place));
    }
    refuse_equal_names(reading, ratings.labels, place_of(object, "labels"), "");
    const std::size_t pairs = pair_count(labels.size());
    const auto values = array_field(object, "condensed", 0, pair_count(limits::kMaxPatterns));
    if (values.size() != pairs && reading.fault.empty()) {
        reading.fault = reading.file + ": " + place_of(object, "condensed") + ": expected " +
                        grouped_digits(pairs) + " values, one for each pair of " +
                        grouped_digits(labels.size()) + " labels, got " +
                        grouped_digits(values.size());
    }
    for (std::size_t k = 0; k < values.size() && reading.fault.empty(); ++k) {
        const std::string place = place_of(object, "condensed") + "/" + std::to_string(k);
        ratings.condensed.push_back(
            values[k]->is_null() ? kUnrated : number_at(reading, *values[k], place, kAnyNumber));
    }
    ratings.file = text_field(object, "file", "");
    ratings.mark = rating_mark_in(object, ratings.file);
    ratings.versions = versions_of(object, labels.size());
    ratings.unknown_json = kept_text(unknown_fields(object));
    return ratings;
}

void read_ratings(JsonObject& object, PatternSet& set) {
    const auto elements = array_field(object, "ratings", 0, kMaxRatings);
    for (std::size_t k = 0; k < elements.size() && may_go_on(*object.reading); ++k) {
        JsonObject fields = object_at(*object.reading, *elements[k],
                                      place_of(object, "ratings") + "/" + std::to_string(k));
        set.ratings.push_back(ratings_of(fields));
    }
}

// The format first: in a newer one everything else may look wrong.
void read_format(JsonObject& object) {
    constexpr Range kFormats{1, 1e9};
    JsonReading& reading = *object.reading;
    const Json* value = field(object, "tactspace");
    if (value == nullptr && object.value != nullptr && !object.value->contains("patterns")) {
        reading.fault = reading.file + ": is not a set of tactspace, expected the keys " +
                        "\"tactspace\" and \"patterns\"";
    }
    const int format = whole_field(object, "tactspace", kSetFormat, kFormats);
    if (format > kSetFormat && reading.fault.empty()) {
        reading.fault = reading.file + ": made by a newer version (format " +
                        std::to_string(format) + "); this program reads format " +
                        std::to_string(kSetFormat);
    }
}

// A path as the set file in `folder` names it.
std::string path_from(const fs::path& folder, const std::string& path) {
    if (folder.empty() || !fs::path(path).is_absolute()) return path;
    std::error_code none;
    const fs::path base = fs::weakly_canonical(folder, none);
    const fs::path relative = fs::path(path).lexically_relative(base);
    return relative.empty() ? path : relative.generic_string();
}

Json json_of(const Measurement& measurement, const fs::path& folder) {
    const std::string path = path_from(folder, measurement.path);
    const bool is_text = !first_invalid_utf8(path);
    Json fields = {{"waveform", is_text ? path : percent_encoded(path)},
                   {"scale_g", measurement.scale_g}};
    if (!is_text) fields["percent_encoded"] = true;
    if (!measurement.measures.empty()) fields["measures"] = measurement.measures;
    if (!measurement.measures_version.empty()) {
        fields["measures_version"] = measurement.measures_version;
    }
    if (measurement.synthetic) fields["synthetic"] = true;
    return fields;
}

Json json_of(const std::variant<Pattern, Measurement>& source, double set_duration_s,
             const fs::path& folder) {
    if (const auto* pattern = std::get_if<Pattern>(&source)) {
        return json_of(*pattern, set_duration_s);
    }
    return json_of(std::get<Measurement>(source), folder);
}

Json json_of(const VibrationSource& source, double set_duration_s, const fs::path& folder) {
    if (const auto* pattern = std::get_if<Pattern>(&source)) {
        return json_of(*pattern, set_duration_s);
    }
    if (const auto* layered = std::get_if<LayeredPattern>(&source)) {
        return json_of(*layered, set_duration_s, folder);
    }
    return json_of(std::get<Measurement>(source), folder);
}

// What was noted of parts has nowhere to go once they are gone: points of a curve, or all that a
// pattern had before it became layers.
void restore_unknown_of(Json& fields, const Vibration& vibration) {
    Json unknown = kept_json(vibration.unknown_json);
    if (!unknown.is_object()) return;
    constexpr std::array kDrawn{"amplitude_curve", "frequency_curve", "transients"};
    constexpr std::array kOfPatterns{"carriers", "modulation", "rhythm"};
    const auto erase_gone = [](const Json& from, Json& notes, const auto& keys) {
        for (const char* key : keys) {
            if (!from.contains(key)) notes.erase(key);
        }
    };
    if (!std::holds_alternative<Measurement>(vibration.source)) {
        erase_gone(fields, unknown, kDrawn);
        erase_gone(fields, unknown, std::array{"layers"});
    }
    if (std::holds_alternative<LayeredPattern>(vibration.source)) {
        erase_gone(fields, unknown, kOfPatterns);
    }
    if (unknown.contains("layers")) {
        for (std::size_t k = 0; k < fields["layers"].size(); ++k) {
            const auto notes = unknown["layers"].find(std::to_string(k));
            if (notes != unknown["layers"].end()) erase_gone(fields["layers"][k], *notes, kDrawn);
        }
    }
    restore_unknown(fields, unknown);
}

Json json_of(const Vibration& vibration, double set_duration_s, const fs::path& folder) {
    Json fields = {{"name", vibration.name}};
    fields.update(json_of(vibration.source, set_duration_s, folder));
    if (vibration.locked) fields["locked"] = true;
    if (vibration.dropped) fields["dropped"] = true;
    if (!vibration.colour.empty()) fields["colour"] = vibration.colour;
    if (vibration.ring) fields["mark"] = "ring";
    if (!vibration.note.empty()) fields["note"] = vibration.note;
    if (vibration.generated) fields["generated"] = true;
    if (vibration.effect != EffectOrigin{}) {
        fields["effect"] = {{"format", vibration.effect.format},
                            {"actuator", vibration.effect.actuator}};
    }
    restore_unknown_of(fields, vibration);
    return fields;
}

Json json_of(const Ratings& ratings) {
    Json fields = {
        {"name", ratings.name}, {"labels", ratings.labels}, {"condensed", ratings.condensed}};
    if (!ratings.file.empty()) fields["file"] = ratings.file;
    if (!ratings.versions.empty()) fields["versions"] = ratings.versions;
    if (ratings.mark.synthetic) fields["synthetic"] = true;
    if (ratings.mark.left_out > 0) fields["left_out"] = ratings.mark.left_out;
    if (ratings.mark.rehearsals > 0) fields["rehearsals"] = ratings.mark.rehearsals;
    restore_text(fields, ratings.unknown_json);
    return fields;
}

// {"Pulse": [0.12, -0.9, 0.3], ..}
MapPlaces map_places_field(JsonObject& object) {
    constexpr Range kCoordinate{-1000.0, 1000.0};
    MapPlaces places;
    JsonObject all = object_field(object, "map_places");
    if (all.value == nullptr) return places;
    for (const auto& [name, value] : all.value->items()) {
        for (const Json* number : array_field(all, name, 2, 3)) {
            places.at[name].push_back(
                number_at(*object.reading, *number, place_of(all, name), kCoordinate));
        }
    }
    return places;
}

Json json_of(const MapPlaces& places) {
    Json json = Json::object();
    for (const auto& [name, coordinates] : places.at) json[name] = coordinates;
    return json;
}

}  // namespace

LayeredPattern layered_of(JsonObject& object, double set_duration_s, Json& unknown) {
    LayeredPattern layered;
    read_objects(object, "layers", 1, limits::kMaxLayers, unknown,
                 [&](JsonObject& one, Json& of_one) {
                     layered.layers.push_back(layer_of(one, set_duration_s, of_one));
                 });
    return layered;
}

namespace {

std::size_t count_of_accented(const PatternSet& set) {
    return static_cast<std::size_t>(
        std::ranges::count_if(set.vibrations, [](const Vibration& vibration) {
            return std::ranges::any_of(patterns_in(vibration), [](const Pattern* pattern) {
                return pattern->accents == Accents::joined && has_accents(*pattern);
            });
        }));
}

// Sets of before the key may have been made where transients were added: that is said until the set
// is saved.
void tell_accents(JsonObject& object, const PatternSet& set, std::vector<std::string>& remarks) {
    constexpr std::array kWords{"joined"};
    const bool is_known = field(object, "accents") != nullptr;
    choice_field(object, "accents", 0, kWords);
    const std::size_t count = is_known ? 0 : count_of_accented(set);
    if (count == 0) return;
    remarks.push_back(object.reading->file + ": " + counted(count, "pattern has", "patterns have") +
                      " transients over a vibration; they are joined to it, so that their energies "
                      "add. \"accents\": \"added\" in a pattern adds them sample by sample, as "
                      "before November 2026");
}

}  // namespace

PatternSet set_of(JsonReading& reading, const Json& document, std::vector<std::string>& remarks) {
    PatternSet set;
    JsonObject object = object_at(reading, document, "");
    read_format(object);
    if (!reading.fault.empty()) return set;
    set.name = name_field(object, "name", "");
    set.duration_s = number_field(object, "duration_s", set.duration_s, limits::kDurationS);
    read_vibrations(object, set, remarks);
    read_ratings(object, set);
    set.told_apart = told_apart_field(object);
    Json unknown = Json::object();
    Json of_model = Json::object();
    JsonObject model = object_field(object, "model");
    set.model_origin.trained_on = text_field(model, "trained_on", {});
    set.model_origin.synthetic = yes_no_field(model, "synthetic", false);
    set.model_origin.changed_by_hand = yes_no_field(model, "changed_by_hand", false);
    set.model = model_of(model, of_model);
    note_unknown(unknown, "model", of_model);
    Json of_study = Json::object();
    JsonObject study = object_field(object, "study");
    set.study = study_design_of(study, of_study);
    note_unknown(unknown, "study", of_study);
    set.map_places = map_places_field(object);
    tell_accents(object, set, remarks);
    Json of_steps = Json::object();
    JsonObject steps = object_field(object, "felt_steps");
    set.felt_steps = felt_steps_of(steps, of_steps);
    note_unknown(unknown, "felt_steps", of_steps);
    if (document.contains("generator")) {
        Json of_generator = Json::object();
        JsonObject generator = object_field(object, "generator");
        set.generator = design_space_of(generator, set.duration_s, of_generator);
        note_unknown(unknown, "generator", of_generator);
    }
    unknown.update(unknown_fields(object));
    set.unknown_json = kept_text(unknown);
    return set;
}

Json json_of(const PatternSet& set, const fs::path& folder) {
    Json document = {{"tactspace", kSetFormat}, {"name", set.name}, {"duration_s", set.duration_s}};
    if (count_of_accented(set) > 0) document["accents"] = "joined";
    document["patterns"] = Json::array();
    for (const Vibration& vibration : set.vibrations) {
        document["patterns"].push_back(json_of(vibration, set.duration_s, folder));
    }
    for (const Ratings& ratings : set.ratings) document["ratings"].push_back(json_of(ratings));
    for (const ToldApart& told : set.told_apart) document["told_apart"].push_back(json_of(told));
    Json model = json_of(set.model);
    if (!set.model_origin.trained_on.empty()) model["trained_on"] = set.model_origin.trained_on;
    if (set.model_origin.synthetic) model["synthetic"] = true;
    if (set.model_origin.changed_by_hand) model["changed_by_hand"] = true;
    if (!model.empty()) document["model"] = model;
    const Json study = json_of(set.study);
    if (!study.empty()) document["study"] = study;
    if (!set.map_places.at.empty()) document["map_places"] = json_of(set.map_places);
    const Json steps = json_of(set.felt_steps);
    if (!steps.empty()) document["felt_steps"] = steps;
    if (set.generator) document["generator"] = json_of(*set.generator, set.duration_s);
    restore_text(document, set.unknown_json);
    return document;
}

Json json_of(const LayeredPattern& layered, double set_duration_s, const fs::path& folder) {
    Json layers = Json::array();
    for (const Layer& layer : layered.layers) {
        Json fields = Json::object();
        if (!layer.name.empty()) fields["name"] = layer.name;
        if (layer.gain != 1.0) fields["gain"] = layer.gain;
        if (layer.offset_s != 0.0) fields["offset_s"] = layer.offset_s;
        if (layer.mute) fields["mute"] = true;
        if (layer.solo) fields["solo"] = true;
        fields.update(json_of(layer.source, set_duration_s, folder));
        layers.push_back(std::move(fields));
    }
    return {{"layers", std::move(layers)}};
}

}  // namespace tact
