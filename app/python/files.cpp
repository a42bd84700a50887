#include "app/python/parts.h"

#include <pybind11/stl.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cerrno>
#include <iterator>
#include <system_error>

#include "model/export/exported_files.h"
#include "model/io/people/ratings_file.h"
#include "model/io/set/load.h"
#include "model/io/set/measured_files.h"
#include "model/io/set/model_file.h"
#include "model/io/set/set_file.h"
#include "model/text/numbers.h"
#include "model/text/utc_time.h"

namespace tact {

namespace py = pybind11;
namespace fs = std::filesystem;
using namespace py::literals;  // NOLINT(google-build-using-namespace): of _a

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

namespace py = pybind11;
namespace fs = std::filesystem;

namespace {

ExportTarget target_in(const py::object& format, const py::object& onto, const py::object& rate_hz,
                       const py::object& bits, const PatternSet& set) {
    const std::string actuator = text_in(onto, "onto");
    ExportTarget target = value_of(export_target_named(text_in(format, "format"), actuator));
    if (!rate_hz.is_none()) {
        if (!is_sampled(target.format)) {
            throw py::value_error("rate_hz: expected format \"wav\" or \"csv\", \"" +
                                  std::string(traits(target.format).key) + "\" has no samples");
        }
        target.sampled.rate_hz = within(rate_hz, "rate_hz", {1.0, 1e6});
        if (std::ranges::find(kExportRatesHz, target.sampled.rate_hz) == std::end(kExportRatesHz)) {
            throw py::value_error("rate_hz: expected 10000, 44100 or 48000, got " +
                                  shortest_digits(target.sampled.rate_hz));
        }
    }
    if (!bits.is_none()) {
        if (target.format != TargetFormat::wav) {
            throw py::value_error("bits: expected format \"wav\", got \"" +
                                  std::string(traits(target.format).key) + "\"");
        }
        take_wave_bits(target.sampled, kWaveBits[choice_of(bits, "bits", kWaveBits)]);
    }
    if (actuator.empty()) target.map = usual_target(target.format, set).map;
    return target;
}

void refuse_taken(const fs::path& folder, const PatternSet& part, TargetFormat format) {
    const std::vector<std::string> taken =
        taken_names(folder, with_second_files(effect_file_names(part, format), format));
    if (taken.empty()) return;
    throw_error((folder / taken.front()).string() +
                ": cannot be written: " + std::generic_category().message(EEXIST));
}

}  // namespace

// NOLINTNEXTLINE(readability-function-size): it has the arguments of Python's
py::dict export_set(const py::object& given, const py::object& folder, const py::object& format,
                    const py::object& patterns, const py::object& onto, const py::object& rate_hz,
                    const py::object& bits, const py::object& count, const py::object& loss,
                    const py::object& overwrite, const py::object& threads,
                    const py::object& progress) {
    Progress told(progress);
    const PatternSet set = pattern_set_of(given);
    const fs::path out = path_in(folder, "folder");
    const ExportTarget target = target_in(format, onto, rate_hz, bits, set);
    const PatternSet part =
        value_of(part_to_export(set, texts_in(patterns, "patterns"), target.format, "patterns"));
    if (!py::bool_(overwrite)) refuse_taken(out, part, target.format);
    ExportedFilesOptions options;
    options.without_loss = !py::bool_(loss);
    options.subset_count = static_cast<std::size_t>(whole_within(count, "count", {0.0, 1e4}));
    options.threads = threads_of(threads);
    options.progress = told.for_work("predicting what it costs");
    const auto exported = beside_python(
        [&](std::stop_token stop) {
            options.stop = stop;
            return exported_files(part, target, utc_today(), options);
        },
        &told);
    value_of(
        beside_python([&](const std::stop_token&) { return write_files(out, exported->files); }));
    return python_of(json_of(*exported, part, out));
}

}  // namespace tact
