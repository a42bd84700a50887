#include <pybind11/stl.h>

#include <nlohmann/json.hpp>

#include "app/python/beside_python.h"
#include "app/python/functions.h"
#include "app/python/values.h"
#include "model/io/people/ratings_file.h"
#include "model/io/set/load.h"
#include "model/io/set/model_file.h"
#include "model/io/set/model_json.h"
#include "model/io/set/set_json.h"
#include "model/set/layers.h"
#include "model/set/set_ratings.h"

namespace tact {

namespace py = pybind11;
using namespace py::literals;

namespace {

py::object own_ratings(const PatternSet& set) {
    if (set.ratings.empty()) return py::none();
    return python_of(value_of(study_of(set)));
}

py::dict dict_of(const Loaded& loaded) {
    const PatternSet& set = loaded.set;
    py::list waves, patterns, measures, synthetic, locked, dropped;
    for (std::size_t k = 0; k < set.vibrations.size(); ++k) {
        const Vibration& one = set.vibrations[k];
        const auto* pattern = std::get_if<Pattern>(&one.source);
        const auto* measured = std::get_if<Measurement>(&one.source);
        const auto* layered = std::get_if<LayeredPattern>(&one.source);
        waves.append(array_of(waveform_of(one).samples_g));
        const double usual_s = Pattern().duration_s;
        patterns.append(pattern != nullptr   ? python_of(json_of(*pattern, usual_s))
                        : layered != nullptr ? python_of(json_of(*layered, usual_s, {}))
                                             : py::none());
        measures.append(measured != nullptr ? measured->measures : "");
        synthetic.append(is_synthetic(one));
        if (one.locked) locked.append(k);
        if (one.dropped) dropped.append(k);
    }
    return py::dict("name"_a = set.name, "names"_a = names_of(set), "waves"_a = waves,
                    "rate_hz"_a = kModelRateHz, "patterns"_a = patterns,
                    "model"_a = python_of(json_of(set.model)), "ratings"_a = own_ratings(set),
                    "measures"_a = measures, "synthetic"_a = synthetic, "locked"_a = locked,
                    "dropped"_a = dropped, "remarks"_a = loaded.remarks);
}

}  // namespace

py::dict read_set(const std::filesystem::path& path) {
    Loaded loaded = value_of(beside_python([&](const std::stop_token&) { return load_set(path); }));
    if (std::string synthetic = remark_on_synthetic(loaded.set.model_origin); !synthetic.empty()) {
        loaded.remarks.push_back("the set's model: " + std::move(synthetic));
    }
    for (const std::string& one : loaded.left_out) loaded.remarks.push_back("not read: " + one);
    for (const std::string& remark : loaded.remarks) warn(remark);
    return dict_of(loaded);
}

py::dict read_ratings_file(const std::filesystem::path& path,
                           const std::optional<std::vector<std::string>>& names,
                           const std::string& scale) {
    constexpr const char* kScales[] = {"guess", "dissimilarity", "similarity"};
    const auto as = static_cast<RatingScale>(choice_of(scale, "scale", kScales));
    LoadedRatings loaded = value_of(beside_python(
        [&](const std::stop_token&) { return read_ratings(std::span(&path, 1), as); }));
    if (names) loaded.study = value_of(matched(loaded.study, *names));
    if (!loaded.study.gone.empty()) loaded.remarks.push_back(words_on_gone(loaded.study.gone));
    for (const std::string& remark : loaded.remarks) warn(remark);
    py::list left_out;
    for (const LeftOutParticipant& one : loaded.left_out) {
        left_out.append(py::dict("participant"_a = one.participant, "why"_a = one.why));
    }
    py::dict result = python_of(loaded.study);
    result["left_out"] = left_out;
    result["remarks"] = loaded.remarks;
    return result;
}

}  // namespace tact
