// tactspace export: patterns as files of other programs, in words what each loses, and what the
// whole costs in perception.
//
// Nothing is written where a file is in the way, unless it may be replaced, nor before all that is
// lost is known.

#include <algorithm>
#include <iostream>
#include <nlohmann/json.hpp>

#include "app/command_line/commands.h"
#include "app/command_line/interrupt.h"
#include "app/command_line/loss_output.h"
#include "app/command_line/output.h"
#include "app/export/effect_files.h"
#include "app/export/export_report.h"
#include "app/rendering/labels.h"
#include "app/session/path_json.h"
#include "model/export/export_loss.h"
#include "model/subset/set_subset.h"
#include "model/text/json_fields.h"
#include "model/text/shown_text.h"
#include "model/text/utc_time.h"

namespace tact {

namespace {

constexpr double kSubsetLimitS = 60.0;

// Those asked for, in the set's order; all that the format holds where none is.
Expected<PatternSet> asked_part(const PatternSet& set, const std::vector<std::string>& names,
                                TargetFormat format) {
    std::vector<bool> wanted(set.vibrations.size(), names.empty());
    for (const std::string& name : names) {
        const auto at = place_of(set, name);
        if (!at) return at.error();
        if (!is_held(set.vibrations[*at], format)) {
            return Error{"--pattern: expected a pattern, \"" + name + "\" is a recording"};
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

// With the rate and the encoding that are asked for.
Expected<ExportTarget> target_of(const ExportCommand& command) {
    auto target = export_target_named(command.format, command.onto);
    if (!target) return target;
    const bool wav = target->format == TargetFormat::wav;
    if (command.rate_hz && !is_sampled(target->format)) {
        return Error{"--rate: expected --format wav or csv, " + command.format + " has no samples"};
    }
    if (!command.bits.empty() && !wav) {
        return Error{"--bits: expected --format wav, got " + command.format};
    }
    target->sampled.rate_hz = command.rate_hz.value_or(target->sampled.rate_hz);
    if (command.bits == "16") target->sampled.encoding = WaveEncoding::int16;
    if (command.bits == "float") target->sampled.encoding = WaveEncoding::float32;
    return target;
}

struct Exported {
    ExportTarget target;             // with its full scale
    std::vector<std::string> names;  // of the patterns' files
    std::vector<TextFile> files;     // those, with what belongs to each, and the page
    std::vector<std::vector<std::string>> remarks;
    std::optional<ExportLoss> loss;
};

// All of it, before any is written.
Expected<Exported> exported_part(const ExportCommand& command, const PatternSet& part,
                                 const ExportTarget& target, std::stop_token stop) {
    const Error stopped{"stopped, and nothing is written"};
    const std::string date = utc_today();
    const std::vector<std::string> names = effect_file_names(part, target.format);
    Exported result{target, names, {}, {}, {}};
    if (command.without_loss) {
        const auto made = exported_set(part, target, command.common.threads, stop, date);
        if (!made) return stopped;
        result.target = made->target;
        for (std::size_t k = 0; k < names.size(); ++k) {
            const ExportedPattern& one = *made->patterns[k];
            add_files(result.files, names[k], target.format, one.text, one.beside);
            result.remarks.push_back(one.remarks);
        }
        return result;
    }
    ExportLossOptions options;
    options.subset_count = static_cast<std::size_t>(command.count);
    options.time_limit_s = kSubsetLimitS;
    options.date = date;
    options.threads = command.common.threads;
    options.stop = stop;
    options.progress = progress_line("predicting what it costs");
    result.loss = export_loss(part, target, options);
    if (!result.loss) return stopped;
    result.target = result.loss->target;
    std::vector<std::size_t> written;
    for (std::size_t k = 0; k < names.size(); ++k) {
        written.push_back(k);
        add_files(result.files, names[k], target.format, result.loss->files[k],
                  result.loss->beside[k]);
        result.remarks.push_back(result.loss->patterns[k].remarks);
    }
    result.files.push_back({kExportReport, export_report({*result.loss, part, written, names})});
    return result;
}

// `mark`: of the model that says what it costs.
void print_table(const Exported& exported, const std::filesystem::path& folder,
                 const NumberMark& mark) {
    for (std::size_t k = 0; k < exported.remarks.size(); ++k) {
        std::string file = (folder / exported.names[k]).string();
        if (*traits(exported.target.format).beside != '\0') {
            file += " with " + name_beside(exported.names[k], exported.target.format);
        }
        std::cout << shown_text(file) << "\n";
        for (const std::string& remark : exported.remarks[k]) {
            std::cout << "    " << shown_text(remark) << "\n";
        }
        if (exported.remarks[k].empty()) std::cout << "    nothing lost\n";
    }
    if (!exported.loss) return;
    std::cout << text_of(Labels{.mark = mark}) << text_of(*exported.loss);
}

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

void print_json(const Exported& exported, const PatternSet& part,
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
    if (exported.loss) {
        answer["loss"] = json_of(*exported.loss);
        add_labels(answer["loss"], {.mark = mark_of(part)});
    }
    std::cout << text_of_json(answer) << "\n";
}

// Before the work, which may take a while.
Expected<Done> check_free(const ExportCommand& command, const PatternSet& part,
                          const ExportTarget& target) {
    if (command.overwrite) return Done{};
    std::vector<std::string> names =
        with_second_files(effect_file_names(part, target.format), target.format);
    if (!command.without_loss) names.emplace_back(kExportReport);
    const std::vector<std::string> taken = taken_names(command.out, names);
    if (taken.empty()) return Done{};
    return Error{(command.out / taken.front()).string() +
                 ": is there already, expected another folder or --overwrite"};
}

}  // namespace

Expected<Done> run(const ExportCommand& command) {
    const Interrupt interrupt;  // first: threads inherit what it blocks
    auto target = target_of(command);
    if (!target) return target.error();
    const Expected<PatternSet> set = load_as_meant(command.common);
    if (!set) return set.error();
    if (command.onto.empty()) target->map = usual_target(target->format, *set).map;
    const auto part = asked_part(*set, command.patterns, target->format);
    if (!part) return part.error();
    if (const auto free = check_free(command, *part, *target); !free) return free;
    const auto exported = exported_part(command, *part, *target, interrupt.token());
    if (!exported) return exported.error();
    if (const auto written = write_files(command.out, exported->files); !written) return written;
    std::cerr << "tactspace: wrote " << exported->remarks.size() << " patterns"
              << (exported->loss ? std::string(" and ") + kExportReport : "") << " to "
              << command.out.string() << "; " << meaning_of(exported->target) << "\n";
    const std::size_t left_out = set->vibrations.size() - part->vibrations.size();
    if (command.patterns.empty() && left_out > 0) {
        std::cerr << "tactspace: " << left_out << " recordings are left out\n";
    }
    if (command.common.json) {
        print_json(*exported, *part, command.out);
    } else {
        print_table(*exported, command.out, mark_of(*part));
    }
    return Done{};
}

}  // namespace tact
