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
#include "model/export/export_loss.h"
#include "model/subset/set_subset.h"
#include "model/text/utc_time.h"

namespace tact {

namespace {

constexpr double kSubsetLimitS = 60.0;

// Those asked for, in the set's order; all but recordings where none is.
Expected<PatternSet> asked_part(const PatternSet& set, const std::vector<std::string>& names) {
    std::vector<bool> wanted(set.vibrations.size(), names.empty());
    for (const std::string& name : names) {
        const auto at = place_of(set, name);
        if (!at) return at.error();
        if (!std::holds_alternative<Pattern>(set.vibrations[*at].source)) {
            return Error{"--pattern: expected a pattern, \"" + name + "\" is a recording"};
        }
        wanted[*at] = true;
    }
    std::vector<std::size_t> asked;
    for (std::size_t k = 0; k < wanted.size(); ++k) {
        const bool is_pattern = std::holds_alternative<Pattern>(set.vibrations[k].source);
        if (wanted[k] && is_pattern) asked.push_back(k);
    }
    if (asked.empty()) return Error{"expected patterns to export, the set has recordings alone"};
    return part_of(set, asked);
}

struct Exported {
    std::vector<TextFile> files;
    std::vector<std::vector<std::string>> remarks;
    std::optional<ExportLoss> loss;
};

// All of it, before any is written.
Expected<Exported> exported_part(const ExportCommand& command, const PatternSet& part,
                                 const ExportTarget& target, std::stop_token stop) {
    const Error stopped{"stopped, and nothing is written"};
    const std::string date = utc_today();
    const std::vector<std::string> names = effect_file_names(part, target.format);
    Exported result;
    if (command.without_loss) {
        const auto made = exported_set(part, target, command.common.threads, stop, date);
        if (!made) return stopped;
        for (std::size_t k = 0; k < names.size(); ++k) {
            result.files.push_back({names[k], made->patterns[k]->text});
            result.remarks.push_back(made->patterns[k]->remarks);
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
    std::vector<std::size_t> written;
    for (std::size_t k = 0; k < names.size(); ++k) {
        written.push_back(k);
        result.files.push_back({names[k], result.loss->files[k]});
        result.remarks.push_back(result.loss->patterns[k].remarks);
    }
    result.files.push_back({kExportReport, export_report({*result.loss, part, written, names})});
    return result;
}

void print_table(const Exported& exported, const std::filesystem::path& folder) {
    for (std::size_t k = 0; k < exported.remarks.size(); ++k) {
        std::cout << (folder / exported.files[k].name).string() << "\n";
        for (const std::string& remark : exported.remarks[k]) std::cout << "    " << remark << "\n";
        if (exported.remarks[k].empty()) std::cout << "    nothing lost\n";
    }
    if (exported.loss) std::cout << text_of(*exported.loss);
}

void print_json(const Exported& exported, const PatternSet& part, const ExportTarget& target,
                const std::filesystem::path& folder) {
    nlohmann::json list = nlohmann::json::array();
    for (std::size_t k = 0; k < exported.remarks.size(); ++k) {
        list.push_back({{"pattern", part.vibrations[k].name},
                        {"file", (folder / exported.files[k].name).string()},
                        {"remarks", exported.remarks[k]}});
    }
    nlohmann::json answer{{"format", traits(target.format).key},
                          {"actuator", target.map.name},
                          {"actuator_source", target.map.source},
                          {"files", list}};
    if (exported.loss) answer["loss"] = json_of(*exported.loss);
    std::cout << answer.dump() << "\n";
}

// Before the work, which may take a while.
Expected<Done> check_free(const ExportCommand& command, const PatternSet& part,
                          const ExportTarget& target) {
    if (command.overwrite) return Done{};
    std::vector<std::string> names = effect_file_names(part, target.format);
    if (!command.without_loss) names.emplace_back(kExportReport);
    const std::vector<std::string> taken = taken_names(command.out, names);
    if (taken.empty()) return Done{};
    return Error{(command.out / taken.front()).string() +
                 ": is there already, expected another folder or --overwrite"};
}

}  // namespace

Expected<Done> run(const ExportCommand& command) {
    const Interrupt interrupt;  // first: threads inherit what it blocks
    const auto target = export_target_named(command.format, command.onto);
    if (!target) return target.error();
    const Expected<PatternSet> set = load_as_meant(command.common);
    if (!set) return set.error();
    const auto part = asked_part(*set, command.patterns);
    if (!part) return part.error();
    if (const auto free = check_free(command, *part, *target); !free) return free;
    const auto exported = exported_part(command, *part, *target, interrupt.token());
    if (!exported) return exported.error();
    if (const auto written = write_files(command.out, exported->files); !written) return written;
    std::cerr << "tactspace: wrote " << exported->remarks.size() << " patterns"
              << (exported->loss ? std::string(" and ") + kExportReport : "") << " to "
              << command.out.string() << "; actuator " << target->map.name << ": "
              << target->map.source << "\n";
    const std::size_t left_out = set->vibrations.size() - part->vibrations.size();
    if (command.patterns.empty() && left_out > 0) {
        std::cerr << "tactspace: " << left_out << " recordings are left out\n";
    }
    if (command.common.json) {
        print_json(*exported, *part, *target, command.out);
    } else {
        print_table(*exported, command.out);
    }
    return Done{};
}

}  // namespace tact
