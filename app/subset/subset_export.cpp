#include "app/subset/subset_export.h"

#include <algorithm>
#include <array>
#include <cstdio>

#include "app/compare/people_text.h"
#include "app/document/editing.h"
#include "app/map/map_follow.h"
#include "app/pictures/pictures.h"
#include "app/rendering/rendered_set.h"
#include "app/session/folders.h"
#include "app/subset/subset_follow.h"
#include "app/subset/subset_state.h"
#include "app/ui/file_question.h"
#include "model/io/set/set_file.h"
#include "model/subset/set_subset.h"
#include "model/text/atomic_file.h"
#include "viz/drawing/plot.h"

namespace tact {

namespace {

namespace fs = std::filesystem;

constexpr std::array kFiles{"subset.tactspace.json", "subset.md", "map.png", "map.svg"};

// A name as a cell of a Markdown table.
std::string cell(const std::string& text) {
    std::string result;
    for (const char c : text) {
        if (c == '|' || c == '\\') result += '\\';
        result += c == '\n' ? ' ' : c;
    }
    return result;
}

std::string row(const std::vector<std::string>& cells) {
    std::string line = "|";
    for (const std::string& one : cells) line += " " + one + " |";
    return line + "\n";
}

std::string rule(std::size_t columns) {
    std::string line = "|";
    for (std::size_t k = 0; k < columns; ++k) line += k == 0 ? "---|" : "---:|";
    return line + "\n";
}

std::string parameter_table(const SubsetReport& report) {
    std::vector<std::string> head{"pattern"};
    for (const PatternParameter parameter : kPatternParameters) {
        const ParameterTraits& about = traits(parameter);
        const std::string unit = about.unit;
        head.push_back(std::string(about.name) + (unit.empty() ? "" : ", " + unit));
    }
    head.emplace_back("rhythm");
    std::string table = row(head) + rule(head.size());
    for (const std::size_t member : report.answer.best.members) {
        const Vibration& vibration = report.set.vibrations[member];
        std::vector<std::string> cells{cell(vibration.name)};
        const auto* pattern = std::get_if<Pattern>(&vibration.source);
        for (const PatternParameter parameter : kPatternParameters) {
            const auto value = pattern == nullptr ? std::nullopt : value_of(*pattern, parameter);
            cells.push_back(value ? significant(*value, 4) : "");
        }
        const std::string rhythm = pattern == nullptr ? "measured" : pattern->rhythm.text;
        const char* curves = pattern != nullptr && is_drawn(*pattern) ? " with curves" : "";
        cells.push_back((rhythm.empty() ? "" : "`" + rhythm + "`") + curves);
        table += row(cells);
    }
    return table;
}

std::string distance_table(const SubsetReport& report) {
    const auto& members = report.answer.best.members;
    std::vector<std::string> head{""};
    for (const std::size_t member : members)
        head.push_back(cell(report.set.vibrations[member].name));
    std::string table = row(head) + rule(head.size());
    for (const std::size_t i : members) {
        std::vector<std::string> cells{cell(report.set.vibrations[i].name)};
        for (const std::size_t j : members) {
            const bool is_weakest =
                std::pair(std::min(i, j), std::max(i, j)) == report.answer.best.weakest;
            const std::string value = i == j ? "" : significant(report.dissimilarity(i, j), 4);
            cells.push_back(is_weakest ? "**" + value + "**" : value);
        }
        table += row(cells);
    }
    return table;
}

std::string proof_sentence(const SubsetReport& report) {
    if (report.weakest_of_best) {
        return "It was taken instead of the best one, whose weakest pair has " +
               significant(*report.weakest_of_best, 4) + ".";
    }
    const bool by_sum = report.objective == SubsetObjective::max_sum;
    switch (report.answer.proof) {
        case SubsetProof::optimal:
            return by_sum ? "Proven optimal: no other subset of this size has a larger sum."
                          : "Proven optimal: in no other subset of this size is the weakest pair "
                            "farther apart.";
        case SubsetProof::ties_open:
            return "No weakest pair can be farther apart; time ran out before the sum was settled.";
        case SubsetProof::open:
            break;
    }
    return "Time ran out: the best that was found. No " +
           std::string(by_sum ? "sum" : "weakest pair") + " is above " +
           significant(report.answer.bound, 6) + ".";
}

}  // namespace

std::string report_text(const SubsetReport& report) {
    const Subset& best = report.answer.best;
    const auto& all = report.set.vibrations;
    const auto name = [&](std::size_t member) { return cell(all[member].name); };
    std::string text = "# " + std::to_string(best.members.size()) + " most distinct of " +
                       std::to_string(all.size()) + " patterns\n\n";
    if (!report.set.name.empty()) text += "From the set " + cell(report.set.name) + ". ";
    text += "The weakest pair is " + name(best.weakest.first) + " and " +
            name(best.weakest.second) + ", " + report.quantity + " " +
            significant(best.weakest_dissimilarity, 4) + "; all pairs together " +
            significant(best.sum, 6) + ". " + proof_sentence(report) + "\n\n";
    if (!report.origin.empty()) {
        text += "Distances are of the patterns " + report.origin + ".\n\n";
    }
    std::string locked;
    for (const std::size_t member : best.members) {
        if (all[member].locked) locked += (locked.empty() ? "" : ", ") + name(member);
    }
    if (!locked.empty()) text += "Kept beforehand: " + locked + ".\n\n";
    text += "![The space of all patterns, the picked ones ringed](map.svg)\n\n## Parameters\n\n" +
            parameter_table(report) + "\n## " + report.quantity + " of every pair\n\n" +
            distance_table(report);
    return text;
}

Expected<Done> write_subset(const fs::path& folder, const SubsetReport& report) {
    if (auto made = make_folder(folder); !made) return made;
    const PatternSet part = part_of(report.set, report.answer.best.members);
    if (auto written = write_set_file(folder / kFiles[0], part); !written) return written;
    if (auto written = write_atomically(folder / kFiles[1], report_text(report)); !written)
        return written;
    for (const PictureFormat format : {PictureFormat::png, PictureFormat::svg}) {
        PictureSize size;
        size.format = format;
        size.dark = false;
        const Picture picture =
            space_picture(report.set, report.dissimilarity, report.space, size,
                          {.chosen = report.answer.best.members, .quantity = report.space_of});
        const fs::path file = folder / kFiles[format == PictureFormat::png ? 2 : 3];
        if (auto written = write_picture(file, picture); !written) return written;
    }
    return Done{};
}

void export_subset_dialog(Ui& ui, const Workspace& work, const ShownMap& shown_map,
                          const SubsetState& picking) {
    if (shown_pick(shown_map, picking) == nullptr) return;
    ask_for_file(ui,
                 {.purpose = ChooserPurpose::export_subset,
                  .use = ChooserUse::save_folder,
                  .title = "Export the picked subset into a folder",
                  .extensions = {".json", ".md", ".png", ".svg"},
                  .folders_too = true,
                  .file_names = {kFiles.begin(), kFiles.end()}},
                 work.document.path.parent_path(), "subset");
}

void export_subset(const ShownMap& shown_map, SubsetState& picking, const fs::path& folder) {
    if (shown_pick(shown_map, picking) == nullptr) return;
    picking.export_to = folder;
}

void continue_subset_export(Ui& ui, const ShownMap& shown_map, SubsetState& picking) {
    const fs::path folder = std::exchange(picking.export_to, {});
    const Pick* pick = shown_pick(shown_map, picking);
    if (folder.empty() || pick == nullptr) return;
    SubsetAnswer answer = pick->answer;
    std::optional<double> weakest_of_best;
    if (const Subset* shown = shown_subset(shown_map, picking); shown != &pick->answer.best) {
        weakest_of_best = answer.best.weakest_dissimilarity;
        answer.best = *shown;
    }
    const LiveMap& map = *pick->request.map;
    const char* rating = has_synthetic(map.request.set->ratings) ? "Synthetic rating" : "Rating";
    const std::string quantity =
        pick->request.by_ratings ? rating : traits(pick->request.metric).name;
    const auto& by = map.request.rendered_by;
    const std::string origin = by && !pick->request.by_ratings ? words_on(*by) : "";
    const SubsetReport report{*map.request.set,
                              *pick->dissimilarity,
                              quantity,
                              pick->request.problem.objective,
                              answer,
                              map.space,
                              "PM",
                              weakest_of_best,
                              origin};
    if (const auto written = write_subset(folder, report); !written) {
        return complain(ui, "Not exported: " + written.error().message);
    }
    say(ui, "Exported the subset to " + folder.string());
}

}  // namespace tact
