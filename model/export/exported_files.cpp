#include "model/export/exported_files.h"

#include <nlohmann/json.hpp>
#include <numeric>
#include <span>
#include <utility>

#include "model/export/exported_set.h"
#include "model/export/loss_words.h"
#include "model/io/folders/folder_files.h"
#include "model/io/folders/path_json.h"
#include "model/set/pattern_set.h"
#include "model/subset/set_subset.h"
#include "model/text/atomic_file.h"
#include "model/text/names.h"

namespace tact {

namespace {

constexpr double kSubsetLimitS = 60.0;

nlohmann::json target_json(const ExportTarget& target) {
    nlohmann::json answer{{"format", traits(target.format).key}};
    if (!is_sampled(target.format)) {
        answer["actuator"] = target.map.name;
        answer["actuator_source"] = target.map.source;
        return answer;
    }
    answer["rate_hz"] = target.sampled.rate_hz;
    if (target.format != TargetFormat::wav) return answer;
    const WaveEncoding encoding = target.sampled.encoding;
    answer["full_scale_g"] = target.sampled.full_scale_g;
    answer["bits"] = encoding == WaveEncoding::float32 ? "float"
                     : encoding == WaveEncoding::int16 ? "16"
                                                       : "24";
    return answer;
}

std::vector<std::size_t> written_places(const PatternSet& part,
                                        const ExportedFilesOptions& options) {
    if (!options.written.empty()) return options.written;
    std::vector<std::size_t> all(part.vibrations.size());
    std::iota(all.begin(), all.end(), std::size_t{0});
    return all;
}

ExportedFiles files_alone(const ExportedSet& made, ExportedFiles result) {
    result.target = made.target;
    for (std::size_t k = 0; k < result.names.size(); ++k) {
        const ExportedPattern& one = *made.patterns[k];
        add_files(result.files, result.names[k], result.target.format, one.text, one.beside);
        result.remarks.push_back(one.remarks);
    }
    return result;
}

ExportedFiles files_with_loss(ExportLoss loss, std::span<const std::size_t> written,
                              ExportedFiles result) {
    result.target = loss.target;
    for (std::size_t k = 0; k < result.names.size(); ++k) {
        const std::size_t place = written[k];
        add_files(result.files, result.names[k], result.target.format, loss.files[place],
                  loss.beside[place]);
        result.remarks.push_back(loss.patterns[place].remarks);
    }
    result.loss = std::move(loss);
    return result;
}

}  // namespace

Expected<PatternSet> part_to_export(const PatternSet& set, const std::vector<std::string>& names,
                                    TargetFormat format, const std::string& asked_by) {
    std::vector<bool> wanted(set.vibrations.size(), names.empty());
    for (const std::string& name : names) {
        const auto at = place_of(set, name);
        if (!at) return at.error();
        if (!is_held(set.vibrations[*at], format)) {
            return Error{asked_by + ": expected a pattern, \"" + name + "\" is a recording"};
        }
        wanted[*at] = true;
    }
    std::vector<std::size_t> asked;
    for (std::size_t k = 0; k < wanted.size(); ++k) {
        if (wanted[k] && is_held(set.vibrations[k], format)) asked.push_back(k);
    }
    if (asked.empty()) {
        return Error{set.vibrations.empty()
                         ? "expected patterns to export, the set is empty"
                         : "expected patterns to export, the set has recordings alone"};
    }
    return part_of(set, asked);
}

void take_wave_bits(SampledAs& sampled, const std::string& bits) {
    if (bits == "16") sampled.encoding = WaveEncoding::int16;
    if (bits == "float") sampled.encoding = WaveEncoding::float32;
}

std::optional<ExportedFiles> exported_files(const PatternSet& part, const ExportTarget& target,
                                            const std::string& date,
                                            const ExportedFilesOptions& options) {
    const std::vector<std::size_t> written = written_places(part, options);
    ExportedFiles result{
        target, effect_file_names(part_of(part, written), target.format), {}, {}, {}};
    if (options.known != nullptr) return files_with_loss(*options.known, written, result);
    if (options.without_loss) {
        const ExportTarget scaled = with_full_scale(target, part, options.threads, options.stop);
        const auto made =
            exported_set(part_of(part, written), scaled, options.threads, options.stop, date);
        return made ? std::optional(files_alone(*made, std::move(result))) : std::nullopt;
    }
    ExportLossOptions of_loss;
    of_loss.subset_count = options.subset_count;
    of_loss.time_limit_s = kSubsetLimitS;
    of_loss.date = date;
    of_loss.threads = options.threads;
    of_loss.stop = options.stop;
    of_loss.progress = options.progress;
    auto loss = export_loss(part, target, of_loss);
    if (!loss) return std::nullopt;
    return files_with_loss(*std::move(loss), written, std::move(result));
}

nlohmann::json json_of(const ExportedFiles& exported, const PatternSet& part,
                       const std::filesystem::path& folder) {
    const TargetFormat format = exported.target.format;
    nlohmann::json list = nlohmann::json::array();
    for (std::size_t k = 0; k < exported.remarks.size(); ++k) {
        const std::string& name = exported.names[k];
        nlohmann::json one{{"pattern", part.vibrations[k].name},
                           {"file", path_json(folder / name)},
                           {"remarks", exported.remarks[k]}};
        if (*traits(format).beside != '\0') {
            one["beside"] = path_json(folder / name_beside(name, format));
        }
        list.push_back(std::move(one));
    }
    nlohmann::json answer = target_json(exported.target);
    answer["files"] = list;
    if (exported.loss) answer["loss"] = json_of(*exported.loss);
    return answer;
}

std::vector<std::string> effect_file_names(const PatternSet& set, TargetFormat format) {
    UnusedNames stems;
    std::vector<std::string> names;
    for (const Vibration& one : set.vibrations) {
        if (!is_held(one, format)) continue;
        names.push_back(stems.unused(file_stem(one.name)) + traits(format).ending);
    }
    return names;
}

std::string name_beside(const std::string& name, TargetFormat format) {
    const std::string_view ending = traits(format).ending;
    return name.substr(0, name.size() - ending.size()) + traits(format).beside;
}

std::vector<std::string> with_second_files(const std::vector<std::string>& names,
                                           TargetFormat format) {
    std::vector<std::string> all;
    for (const std::string& name : names) {
        all.push_back(name);
        if (*traits(format).beside != '\0') all.push_back(name_beside(name, format));
    }
    return all;
}

void add_files(std::vector<TextFile>& files, const std::string& name, TargetFormat format,
               const std::string& text, const std::string& beside) {
    files.push_back({name, text});
    if (*traits(format).beside != '\0') files.push_back({name_beside(name, format), beside});
}

std::vector<std::string> taken_names(const std::filesystem::path& folder,
                                     const std::vector<std::string>& names) {
    std::vector<std::string> taken;
    for (const std::string& name : names) {
        if (is_there(folder / name)) taken.push_back(name);
    }
    return taken;
}

Expected<Done> write_files(const std::filesystem::path& folder,
                           const std::vector<TextFile>& files) {
    if (const Expected<Done> made = make_folder(folder); !made) return made;
    for (const TextFile& file : files) {
        if (const auto written = write_atomically(folder / file.name, file.text); !written) {
            return written;
        }
    }
    return Done{};
}

}  // namespace tact
