#include <algorithm>
#include <cerrno>
#include <iterator>
#include <nlohmann/json.hpp>
#include <system_error>

#include "app/python/beside_python.h"
#include "app/python/documents.h"
#include "app/python/functions.h"
#include "app/python/set_dict.h"
#include "app/python/values.h"
#include "model/export/exported_files.h"
#include "model/text/numbers.h"
#include "model/text/utc_time.h"

namespace tact {

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
