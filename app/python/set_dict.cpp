#include "app/python/parts.h"

#include <pybind11/stl.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <unordered_map>

#include "model/io/set/set_json.h"
#include "model/set/layers.h"
#include "model/set/pattern_set.h"
#include "model/set/set_ratings.h"
#include "model/signal/resample.h"

namespace tact {

namespace py = pybind11;
using namespace py::literals;  // NOLINT(google-build-using-namespace): of _a

namespace {

py::object own_ratings(const PatternSet& set) {
    if (set.ratings.empty()) return py::none();
    return python_of(value_of(study_of(set)));
}

py::object pattern_dict(const Vibration& vibration) {
    const double usual_s = Pattern().duration_s;
    if (const auto* pattern = std::get_if<Pattern>(&vibration.source)) {
        return python_of(json_of(*pattern, usual_s));
    }
    if (const auto* layered = std::get_if<LayeredPattern>(&vibration.source)) {
        return python_of(json_of(*layered, usual_s, {}));
    }
    return py::none();
}

// The set that the file behind the dict had, its recordings without samples.
PatternSet set_of_document(const py::dict& dict) {
    if (!dict.contains("document") || dict["document"].is_none()) return {};
    const std::string name = "set[\"document\"]";
    const Json document = json_of(dict_in(dict["document"], name), name);
    JsonReading reading{name, {}, UnknownKeys::kept};
    std::vector<std::string> remarks;
    PatternSet set = set_of(reading, document, remarks);
    if (!reading.fault.empty()) throw py::value_error(reading.fault);
    return set;
}

// The element of a list behind a key; None where the key is missing, an error where the list ends.
py::object element(const py::dict& dict, const char* key, std::size_t k) {
    if (!dict.contains(key)) return py::none();
    const py::object list = dict[key];
    const auto length = static_cast<std::size_t>(py::len(list));
    if (k < length) return list[py::int_(k)];
    throw py::value_error("set[\"" + std::string(key) +
                          "\"]: expected an element for each name, got " + std::to_string(length));
}

Measurement recording_of(const py::dict& dict, std::size_t k) {
    const std::string place = "[" + std::to_string(k) + "]";
    const py::object samples = element(dict, "waves", k);
    if (samples.is_none()) {
        throw py::value_error("set[\"patterns\"]" + place + ": expected a pattern, or samples in " +
                              "set[\"waves\"]" + place);
    }
    const double rate_hz =
        dict.contains("rate_hz") ? rate_of(dict["rate_hz"]) : double{kModelRateHz};
    const Waveform wave = wave_of(samples, "set[\"waves\"]" + place, rate_hz);
    Measurement recording;
    recording.waveform = std::make_shared<const Waveform>(resampled(wave, kModelRateHz));
    const py::object measures = element(dict, "measures", k);
    if (!measures.is_none()) recording.measures = text_in(measures, "set[\"measures\"]" + place);
    const py::object synthetic = element(dict, "synthetic", k);
    recording.synthetic = !synthetic.is_none() && static_cast<bool>(py::bool_(synthetic));
    return recording;
}

std::vector<Vibration> vibrations_of(const py::dict& dict, const PatternSet& before) {
    if (!dict.contains("names")) {
        throw py::value_error("set: expected what read_set() gives; there is no \"names\"");
    }
    std::unordered_map<std::string, const Vibration*> known;
    for (const Vibration& one : before.vibrations) known.emplace(one.name, &one);
    std::vector<Vibration> vibrations;
    for (const std::string& name : texts_in(dict["names"], "set[\"names\"]")) {
        const std::size_t k = vibrations.size();
        const auto it = known.find(name);
        Vibration one = it == known.end() ? Vibration() : *it->second;
        one.name = name;
        const py::object pattern = element(dict, "patterns", k);
        if (pattern.is_none()) {
            one.source = recording_of(dict, k);
        } else {
            one.source = pattern_of(pattern, "set[\"patterns\"][" + std::to_string(k) + "]");
        }
        one.locked = one.dropped = false;
        vibrations.push_back(std::move(one));
    }
    return vibrations;
}

bool are_alike(double a, double b) { return a == b || (std::isnan(a) && std::isnan(b)); }

// Whether the ratings are still those of the set's file, which knows more about them.
bool say_the_same(const RatingStudy& a, const RatingStudy& b) {
    if (a.labels != b.labels || a.judgements.size() != b.judgements.size()) return false;
    for (std::size_t k = 0; k < a.judgements.size(); ++k) {
        const Judgement& one = a.judgements[k];
        const Judgement& other = b.judgements[k];
        if (one.participant != other.participant) return false;
        if (!std::ranges::equal(one.condensed, other.condensed, are_alike)) return false;
    }
    return true;
}

void take_ratings(PatternSet& set, const py::dict& dict) {
    if (!dict.contains("ratings")) return;
    if (dict["ratings"].is_none()) {
        set.ratings.clear();
        return;
    }
    const RatingStudy study = study_of(py::object(dict["ratings"]));
    if (!set.ratings.empty()) {
        const auto before = study_of(set);
        if (before && say_the_same(*before, study)) return;
    }
    set.ratings = kept_ratings(value_of(matched(study, names_of(set))), "");
}

// Parameters that are others than in the set's file have the origin that their dict names.
void take_model(PatternSet& set, const py::dict& dict) {
    if (!dict.contains("model")) return;
    const py::object given = dict["model"];
    PerceptualModelParams model = model_of(given);
    if (model == set.model) return;
    set.model = std::move(model);
    set.model_origin = origin_in(given);
}

}  // namespace

py::dict dict_of(const Loaded& loaded) {
    const PatternSet& set = loaded.set;
    py::list waves;
    py::list patterns;
    py::list measures;
    py::list synthetic;
    py::list locked;
    py::list dropped;
    for (std::size_t k = 0; k < set.vibrations.size(); ++k) {
        const Vibration& one = set.vibrations[k];
        const auto* measured = std::get_if<Measurement>(&one.source);
        waves.append(array_of(waveform_of(one).samples_g));
        patterns.append(pattern_dict(one));
        measures.append(measured != nullptr ? measured->measures : "");
        synthetic.append(is_synthetic(one));
        if (one.locked) locked.append(k);
        if (one.dropped) dropped.append(k);
    }
    return py::dict("name"_a = set.name, "names"_a = names_of(set), "waves"_a = waves,
                    "rate_hz"_a = kModelRateHz, "patterns"_a = patterns,
                    "model"_a = python_of(set.model, set.model_origin),
                    "ratings"_a = own_ratings(set), "measures"_a = measures,
                    "synthetic"_a = synthetic, "locked"_a = locked, "dropped"_a = dropped,
                    "remarks"_a = loaded.remarks, "document"_a = python_of(json_of(set, {})));
}

PatternSet pattern_set_of(const py::object& given) {
    const py::dict dict = dict_in(given, "set");
    PatternSet set = set_of_document(dict);
    set.vibrations = vibrations_of(dict, set);
    const std::size_t count = set.vibrations.size();
    if (dict.contains("name")) set.name = text_in(dict["name"], "set[\"name\"]");
    const auto mark = [&](const char* key, bool Vibration::*field) {
        if (!dict.contains(key)) return;
        for (const std::size_t place :
             places_of(dict[key], "set[\"" + std::string(key) + "\"]", count)) {
            set.vibrations[place].*field = true;
        }
    };
    mark("locked", &Vibration::locked);
    mark("dropped", &Vibration::dropped);
    take_model(set, dict);
    take_ratings(set, dict);
    return set;
}

std::size_t place_in(const py::object& pattern, const PatternSet& set, const std::string& name) {
    if (!py::isinstance<py::str>(pattern)) {
        const auto last = static_cast<double>(set.vibrations.size()) - 1.0;
        return static_cast<std::size_t>(whole_within(pattern, name, {0.0, last}));
    }
    const Expected<std::size_t> place = place_of(set, pattern.cast<std::string>());
    if (!place) throw py::value_error(name + ": " + place.error().message);
    return *place;
}

}  // namespace tact
