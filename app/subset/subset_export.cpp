#include "app/subset/subset.h"

#include <array>
#include <cctype>
#include <utility>

#include "app/compare/compare.h"
#include "app/map/map.h"
#include "app/pictures/pictures.h"
#include "app/progress/progress.h"
#include "app/rendering/rendering.h"
#include "app/report/report.h"
#include "app/session/program_version.h"
#include "app/session/session.h"
#include "app/ui/ui.h"
#include "model/io/recordings/recording.h"
#include "model/io/set/set_file.h"
#include "model/set/felt_versions.h"
#include "model/subset/set_subset.h"
#include "model/text/atomic_file.h"
#include "model/text/names.h"
#include "model/text/utc_time.h"

namespace tact {

namespace {

namespace fs = std::filesystem;

constexpr std::array kFiles{"subset.tactspace.json", "report.html", "map.png", "map.svg"};

// The pair taken as the measure, or the subset's weakest one.
CloserThan closer_than(const Pick& pick, const SubsetState& picking) {
    const PatternSet& set = *pick.request.map->request.set;
    const auto a = place_named(set, picking.reference_a);
    const auto b = place_named(set, picking.reference_b);
    if (picking.too_close != TooClose::reference || !a || !b || *a == *b) {
        return closer_than_picked(pick.answer);
    }
    const std::string names = picking.reference_a + " and " + picking.reference_b;
    return {(*pick.dissimilarity)(*a, *b), names,
            "as far apart as " + names + ", the reference pair that was taken"};
}

}  // namespace

Expected<Done> write_subset(const fs::path& folder, const Report& report) {
    if (auto made = make_folder(folder); !made) return made;
    const PatternSet part = part_of(report.set, report.answer.best.members);
    if (auto written = write_set_file(folder / kFiles[0], part); !written) return written;
    if (auto written = write_atomically(folder / kFiles[1], report_page(report)); !written)
        return written;
    for (const PictureFormat format : {PictureFormat::png, PictureFormat::svg}) {
        PictureSize size;
        size.format = format;
        size.dark = false;
        const Picture picture = space_picture(report.set, report.dissimilarity, report.space, size,
                                              {.chosen = report.answer.best.members,
                                               .quantity = report.space_of,
                                               .mark = phrase_of(report.mark)});
        const fs::path file = folder / kFiles[format == PictureFormat::png ? 2 : 3];
        if (auto written = write_picture(file, picture); !written) return written;
    }
    return Done{};
}

void export_subset_dialog(Ui& ui, const Workspace& work, const ShownMap& shown_map,
                          SubsetState& picking) {
    if (shown_pick(shown_map, picking) == nullptr) return;
    ask_for_file(ui,
                 {.use = ChooserUse::save_folder,
                  .title = "Export the picked subset into a folder",
                  .extensions = {".json", ".html", ".png", ".svg"},
                  .folders_too = true,
                  .file_names = {kFiles.begin(), kFiles.end()},
                  .take = [&](const fs::path& folder) { export_subset(ui, picking, folder); }},
                 work.document.path.parent_path(), "subset");
}

void export_subset(Ui& ui, SubsetState& picking, const fs::path& folder) {
    picking.export_to = folder;
    say(ui, "The subset follows when the most distinct patterns are picked.");
}

void export_report_dialog(Ui& ui, const Workspace& work, SubsetState& picking) {
    const std::string& name = work.document.set.name;
    ask_for_file(ui,
                 {.use = ChooserUse::save,
                  .title = "Export a report, .html",
                  .extensions = {".html"},
                  .take = [&](const fs::path& file) { export_report(ui, picking, file); }},
                 work.document.path.parent_path(),
                 file_stem(name.empty() ? "untitled" : name) + " report.html");
}

void export_report(Ui& ui, SubsetState& picking, const fs::path& file) {
    picking.report_to = file;
    if (extension_of(file) != ".html") picking.report_to += ".html";
    say(ui, "The report follows when the most distinct patterns are picked.");
}

namespace {

Report report_of(const Pick& pick, const Subset& shown, const SubsetState& picking) {
    const LiveMap& map = *pick.request.map;
    const bool by_ratings = pick.request.by_ratings;
    const CloserThan than = closer_than(pick, picking);
    const PatternSet& set = *map.request.set;
    std::string rating = of_people("rating", pick.mark);
    rating.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(rating.front())));
    // People felt all that they rated.
    SetPairs pairs{*pick.dissimilarity, {}};
    if (!by_ratings) pairs.unfelt = unfelt(map.prediction.codes);
    const StalePatterns stale = by_ratings ? stale_patterns(set) : StalePatterns{};
    const Labels labels{.by = by_ratings ? std::nullopt : map.request.rendered_by,
                        .mark = mark_of(set) | pick.mark,
                        .edited = stale.edited,
                        .gone = stale.gone};
    Report report{
        .set = set,
        .felt = by_ratings ? set : *map.played,
        .dissimilarity = *pick.dissimilarity,
        .quantity = by_ratings ? rating : traits(pick.request.metric).name,
        .objective = pick.request.problem.objective,
        .answer = pick.answer,
        .space = map.space,
        .alike = alike_patterns(set, pairs, than.dissimilarity, shown.members.size()),
        .unfelt = pairs.unfelt,
        .left_out = pick.request.with_unfelt ? std::string() : left_out_words(pick.request.unfelt),
        .closer_than = than,
        .by = labels.by,
        .program = kProgramVersion,
        .date = utc_today(),
        .mark = labels.mark,
        .labels = lines_of(labels)};
    if (&shown != &pick.answer.best) {
        report.best_worth = worth_of(pick.answer.best, pick.request.problem.objective);
        report.answer.best = shown;
    }
    if (&shown == &pick.answer.best) report.stability = shown_stability(picking);
    return report;
}

// False: it has to wait for a subset of the present set.
bool is_ready_for_report(const Workspace& work, const ShownMap& shown_map,
                         const SubsetState& picking) {
    const Pick* pick = shown_pick(shown_map, picking);
    return pick != nullptr && !is_pick_stale(work, shown_map, picking) && !is_picking(picking) &&
           !is_unsettled(*pick);
}

// Why the present set will have no subset; empty if it has one, or will.
std::string no_pick_because(const Workspace& work, const ShownMap& shown_map,
                            const SubsetState& picking) {
    if (is_picking(picking)) return {};
    if (picking.cancelled) return "the picking was cancelled; press Pick again, then export";
    if (picking.pick && !is_pick_stale(work, shown_map, picking)) return picking.pick->fault;
    return picking.pick_job.failure();
}

void write_report(Ui& ui, const fs::path& file, const Report& report) {
    if (const auto written = write_atomically(file, report_page(report)); !written) {
        return complain(ui, "Not exported: " + written.error().message);
    }
    say(ui, "Exported the report to " + file.string());
}

void write_subset_and_tell(Ui& ui, const fs::path& folder, const Report& report) {
    if (const auto written = write_subset(folder, report); !written) {
        return complain(ui, "Not exported: " + written.error().message);
    }
    say(ui, "Exported the subset to " + folder.string());
}

}  // namespace

void continue_subset_export(Ui& ui, const Workspace& work, const ShownMap& shown_map,
                            SubsetState& picking) {
    if (const std::string why = no_pick_because(work, shown_map, picking); !why.empty()) {
        picking.export_to.clear();
        picking.report_to.clear();
        return complain(ui, "Not exported: " + why);
    }
    if (!is_ready_for_report(work, shown_map, picking)) return;
    const Pick& pick = *shown_pick(shown_map, picking);
    const Report report = report_of(pick, *shown_subset(shown_map, picking), picking);
    const fs::path folder = std::exchange(picking.export_to, {});
    const fs::path page = std::exchange(picking.report_to, {});
    if (!folder.empty()) write_subset_and_tell(ui, folder, report);
    if (!page.empty()) write_report(ui, page, report);
}

}  // namespace tact
