#include <pybind11/stl.h>

#include "app/python/beside_python.h"
#include "app/python/dicts.h"
#include "app/python/functions.h"
#include "app/python/set_dict.h"
#include "app/python/values.h"
#include "model/io/people/ratings_file.h"
#include "model/io/set/load.h"
#include "model/io/set/measured_files.h"
#include "model/io/set/model_file.h"
#include "model/io/set/set_file.h"

namespace tact {

namespace py = pybind11;
namespace fs = std::filesystem;
using namespace py::literals;

namespace {

// A path, or a list of them.
std::vector<fs::path> paths_in(const py::object& given) {
    if (!py::isinstance<py::list>(given) && !py::isinstance<py::tuple>(given)) {
        return {path_in(given, "path")};
    }
    std::vector<fs::path> paths;
    for (const py::handle one : given) {
        paths.push_back(path_in(one, "path[" + std::to_string(paths.size()) + "]"));
    }
    return paths;
}

// A set is not to be written over effects of another program, nor under their names.
Expected<Done> may_be_replaced(const fs::path& path) {
    if (!path.filename().string().ends_with(".json")) {
        return Error{path.string() + ": expected a set file's name, which ends in .json"};
    }
    std::error_code none;
    if (!fs::exists(path, none) || !holds_effects(path)) return Done{};
    return Error{path.string() +
                 ": holds effects of another program, expected another name for the set"};
}

}  // namespace

py::dict read_set(const py::object& path, const py::object& actuator, const py::object& progress) {
    Progress told(progress);
    const std::vector<fs::path> paths = paths_in(path);
    LoadOptions options;
    if (const std::string name = text_in(actuator, "actuator"); !name.empty()) {
        options.actuator = value_of(actuator_named(name));
    }
    options.progress = told.for_work("reading");
    Loaded loaded = value_of(beside_python(
        [&](std::stop_token stop) {
            options.stop = stop;
            return load_sets(paths, options);
        },
        &told));
    if (std::string synthetic = remark_on_synthetic(loaded.set.model_origin); !synthetic.empty()) {
        loaded.remarks.push_back("the set's model: " + std::move(synthetic));
    }
    for (const std::string& one : loaded.left_out) loaded.remarks.push_back("not read: " + one);
    for (const std::string& remark : loaded.remarks) warn(remark);
    return dict_of(loaded);
}

void write_set(const py::object& path, const py::object& set) {
    const fs::path file = path_in(path, "path");
    value_of(beside_python_or_alone(
        [file, made = pattern_set_of(set)](const std::stop_token&) mutable -> Expected<Done> {
            if (const auto may = may_be_replaced(file); !may) return may;
            if (const auto stored = store_measurements(made, file); !stored) return stored;
            return write_set_file(file, made);
        }));
}

py::dict read_ratings_file(const py::object& path, const py::object& names,
                           const py::object& scale) {
    constexpr const char* kScales[] = {"guess", "dissimilarity", "similarity"};
    const auto as = static_cast<RatingScale>(choice_of(scale, "scale", kScales));
    LoadedRatings loaded =
        value_of(beside_python_or_alone([file = path_in(path, "path"), as](const std::stop_token&) {
            return read_ratings(std::span(&file, 1), as);
        }));
    if (!names.is_none()) loaded.study = value_of(matched(loaded.study, texts_in(names, "names")));
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
