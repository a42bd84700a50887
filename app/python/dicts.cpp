#include "app/python/parts.h"

#include <pybind11/stl.h>

#include <nlohmann/json.hpp>

#include "model/io/set/model_json.h"
#include "model/io/set/set_json.h"
#include "model/set/layers.h"
#include "model/text/names.h"

namespace tact {

namespace py = pybind11;

namespace {

// Reads a whole document; a key that is not known is a mistake, not something to keep.
template <class Read>
auto read_document(const py::object& document, const std::string& name,
                   std::span<const char* const> passed_over, Read read) {
    const Json json = json_of(document, name);
    JsonReading reading{name, {}, UnknownKeys::refused};
    JsonObject object = object_at(reading, json, "");
    for (const char* key : passed_over) (void)field(object, key);
    Json unknown = Json::object();
    auto value = read(object, unknown);
    unknown.update(unknown_fields(object));
    if (!reading.fault.empty()) throw py::value_error(reading.fault);
    return value;
}

// The texts behind a key of the ratings, as names.
std::vector<std::string> names_in(const py::dict& ratings, const char* key) {
    std::vector<std::string> all = texts_in(ratings[key], "ratings[\"" + std::string(key) + "\"]");
    for (const std::string& name : all) {
        if (const std::string fault = name_fault(name); !fault.empty()) {
            throw py::value_error("ratings: " + fault);
        }
    }
    return all;
}

RatingStudy study_of_dict(const py::dict& ratings) {
    for (const char* key : {"names", "participants", "ratings"}) {
        if (!ratings.contains(key)) {
            throw py::value_error("ratings: expected what read_ratings() gives, or distances; " +
                                  std::string("there is no \"") + key + "\"");
        }
    }
    RatingStudy study;
    study.labels = names_in(ratings, "names");
    if (ratings.contains("named")) study.is_named = py::bool_(ratings["named"]);
    const auto participants = names_in(ratings, "participants");
    const Numbers values = numbers_of(ratings["ratings"], "ratings[\"ratings\"]");
    const auto people = static_cast<py::ssize_t>(participants.size());
    const auto pairs = static_cast<py::ssize_t>(pair_count(study.labels.size()));
    if (values.ndim() != 2 || values.shape(0) != people || values.shape(1) != pairs) {
        throw py::value_error("ratings: expected a row a participant, a column a pair, (" +
                              std::to_string(people) + ", " + std::to_string(pairs) + "), got " +
                              shape_of(values));
    }
    for (py::ssize_t k = 0; k < people; ++k) {
        study.judgements.push_back({participants[static_cast<std::size_t>(k)],
                                    {values.data(k, 0), values.data(k, 0) + pairs}});
    }
    if (ratings.contains("synthetic")) {
        for (const std::string& name : names_in(ratings, "synthetic")) {
            study.standings.push_back({.participant = name, .synthetic = true});
        }
    }
    const auto count = [&ratings](const char* key) {
        if (!ratings.contains(key)) return std::size_t{0};
        return static_cast<std::size_t>(
            whole_within(ratings[key], "ratings[\"" + std::string(key) + "\"]", {0.0, 1e9}));
    };
    study.left_out = count("participants_left_out");
    study.rehearsals = count("rehearsals_left_out");
    return study;
}

}  // namespace

PerceptualModelParams model_of(const py::object& model) {
    // An empty dict that has been through R may be an empty list.
    const bool is_empty = py::isinstance<py::list>(model) && py::len(model) == 0;
    if (model.is_none() || is_empty) return {};
    constexpr const char* kOrigin[] = {"trained_on", "synthetic", "changed_by_hand"};
    return read_document(
        dict_in(model, "model"), "model", kOrigin,
        [](JsonObject& object, Json& unknown) { return model_of(object, unknown); });
}

py::dict python_of(const PerceptualModelParams& model, const ModelOrigin& origin) {
    py::dict dict = python_of(json_of(model));
    if (!origin.trained_on.empty()) dict["trained_on"] = origin.trained_on;
    if (origin.synthetic) dict["synthetic"] = true;
    if (origin.changed_by_hand) dict["changed_by_hand"] = true;
    return dict;
}

ModelOrigin origin_in(const py::object& model) {
    if (!py::isinstance<py::dict>(model)) return {};
    const auto is = [&model](const char* key) {
        return model.contains(key) && static_cast<bool>(py::bool_(model[key]));
    };
    const bool is_trained = model.contains("trained_on");
    return {is_trained ? text_in(model["trained_on"], "model[\"trained_on\"]") : "",
            is("synthetic"), is("changed_by_hand")};
}

py::dict dict_in(const py::handle& value, const std::string& name) {
    if (py::isinstance<py::dict>(value)) return py::reinterpret_borrow<py::dict>(value);
    throw py::type_error(name + ": expected a dict, got " + described(value));
}

std::vector<py::dict> dicts_in(const py::object& value, const std::string& name) {
    if (!py::isinstance<py::list>(value) && !py::isinstance<py::tuple>(value)) {
        throw py::type_error(name + ": expected a list of dicts, got " + described(value));
    }
    std::vector<py::dict> dicts;
    for (const py::handle one : value) {
        dicts.push_back(dict_in(one, name + "[" + std::to_string(dicts.size()) + "]"));
    }
    return dicts;
}

VibrationSource pattern_of(const py::handle& given, const std::string& name) {
    const py::dict pattern = dict_in(given, name);
    constexpr const char* kOfItsSet[] = {"name", "locked",    "dropped", "colour",
                                         "mark", "generated", "note",    "effect"};
    const double usual_s = Pattern().duration_s;
    if (!pattern.contains("layers")) {
        return read_document(pattern, name, kOfItsSet, [&](JsonObject& object, Json& unknown) {
            return pattern_of(object, usual_s, unknown);
        });
    }
    Vibration layered;
    layered.source = read_document(
        pattern, name, kOfItsSet,
        [&](JsonObject& object, Json& unknown) { return layered_of(object, usual_s, unknown); });
    if (!recordings_in(layered).empty()) {
        throw py::value_error(name + ": expected layers made of parameters, got a recording");
    }
    const std::string fault = fault_of(std::get<LayeredPattern>(layered.source));
    if (!fault.empty()) throw py::value_error(name + ": " + fault);
    return layered.source;
}

RatingStudy study_of(const py::object& ratings) {
    if (py::isinstance<py::dict>(ratings)) return study_of_dict(ratings);
    const Dissimilarity matrix = dissimilarities_of(ratings, "ratings");
    RatingStudy study;
    for (std::size_t k = 0; k < matrix.size; ++k) study.labels.push_back(std::to_string(k));
    study.is_named = false;
    study.judgements.push_back({"ratings", matrix.condensed});
    return study;
}

py::dict python_of(const RatingStudy& study) {
    const auto people = static_cast<py::ssize_t>(study.judgements.size());
    const auto pairs = static_cast<py::ssize_t>(pair_count(study.labels.size()));
    py::array_t<double> values({people, pairs});
    std::vector<std::string> participants;
    for (py::ssize_t k = 0; k < people; ++k) {
        const Judgement& one = study.judgements[static_cast<std::size_t>(k)];
        participants.push_back(one.participant);
        std::copy(one.condensed.begin(), one.condensed.end(), values.mutable_data(k, 0));
    }
    std::vector<std::string> synthetic;
    for (const Standing& one : study.standings) {
        if (one.synthetic) synthetic.push_back(one.participant);
    }
    py::dict result;
    result["names"] = study.labels;
    result["named"] = study.is_named;
    result["participants"] = participants;
    result["ratings"] = values;
    result["mean"] = square_array(mean_ratings(study));
    result["synthetic"] = synthetic;
    result["participants_left_out"] = study.left_out;
    result["rehearsals_left_out"] = study.rehearsals;
    return result;
}

}  // namespace tact
