// tactspace export: patterns as files of other programs, in words what each loses, and what the
// whole costs in perception.
//
// Nothing is written where a file is in the way, unless it may be replaced, nor before all that is
// lost is known.

#include <iostream>
#include <nlohmann/json.hpp>
#include <numeric>

#include "app/command_line/commands.h"
#include "app/command_line/endings.h"
#include "app/command_line/output.h"
#include "app/export/export.h"
#include "app/rendering/rendering.h"
#include "model/export/exported_files.h"
#include "model/text/json_fields.h"
#include "model/text/shown_text.h"
#include "model/text/utc_time.h"

namespace tact {

namespace {

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
    take_wave_bits(target->sampled, command.bits);
    return target;
}

// All of it with the page on what it costs, before any is written.
Expected<ExportedFiles> exported_part(const ExportCommand& command, const PatternSet& part,
                                      const ExportTarget& target, std::stop_token stop) {
    ExportedFilesOptions options;
    options.without_loss = command.without_loss;
    options.subset_count = static_cast<std::size_t>(command.count);
    options.threads = command.common.threads;
    options.stop = stop;
    if (!command.without_loss) options.progress = progress_line("predicting what it costs");
    auto exported = exported_files(part, target, utc_today(), options);
    if (!exported) return Error{"stopped, and nothing is written"};
    if (!exported->loss) return *std::move(exported);
    std::vector<std::size_t> written(exported->names.size());
    std::iota(written.begin(), written.end(), std::size_t{0});
    exported->files.push_back(
        {kExportReport, export_report({*exported->loss, part, written, exported->names})});
    return *std::move(exported);
}

// `mark`: of the model that says what it costs.
void print_table(const ExportedFiles& exported, const std::filesystem::path& folder,
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

void print_json(const ExportedFiles& exported, const PatternSet& part,
                const std::filesystem::path& folder) {
    nlohmann::json answer = json_of(exported, part, folder);
    if (exported.loss) add_labels(answer["loss"], {.mark = mark_of(part)});
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
    const auto part = part_to_export(*set, command.patterns, target->format, "--pattern");
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
