// Metrics beside what people said: the table, the pairs that disagree, and the paper's findings.

#include <algorithm>

#include "app/compare/compare.h"
#include "app/document/editing.h"
#include "app/document/workspace.h"
#include "app/measured/measured.h"
#include "app/progress/progress.h"
#include "app/ui/widgets.h"
#include "model/text/numbers.h"
#include "viz/charts/scatter_view.h"
#include "viz/drawing/marks.h"
#include "viz/drawing/plot.h"

namespace tact {

namespace {

void draw_views(Ui& ui, const Workspace& work, TableState& table, Comparing& comparing) {
    const float gap = 2.0F * ui.theme.scale;
    const auto view = [&](CompareView which, const char* name) {
        const Item item{.id = std::string("compare:") + name, .label = name};
        if (chip(ui, item, comparing.panel.view == which)) comparing.panel.view = which;
    };
    view(CompareView::table, "Table");
    flow_on(chip_width(ui, "Pairs"), gap);
    view(CompareView::scatter, "Pairs");
    flow_on(chip_width(ui, "Findings"), gap);
    view(CompareView::findings, "Findings");
    flow_on(ImGui::CalcTextSize("Add metric...").x, 2.0F * ui.theme.gap_px);
    const float lower = 2.0F * ui.theme.scale;
    ImGui::SetCursorPosY(ImGui::GetCursorPosY() + lower);
    if (link(ui, {.id = "link:add metric",
                  .label = "Add metric...",
                  .tip = "A metric of your own beside the others: a matrix by the names of the "
                         "patterns (.csv), or a function of two arrays and a rate (.py)."})) {
        add_metric_dialog(ui, work, comparing);
    }
    // Replaces the ratings; without ratings the button below offers to open some.
    if (work.document.set.ratings.empty()) return;
    flow_on(ImGui::CalcTextSize("Load ratings...").x, 2.0F * ui.theme.gap_px);
    ImGui::SetCursorPosY(ImGui::GetCursorPosY() + lower);
    if (link(ui, {.id = "link:load ratings",
                  .label = "Load ratings...",
                  .tip = "A CSV of what people said of these patterns: a square with names, or a "
                         "line a rating with the participant. Names must be those of the "
                         "patterns."})) {
        load_ratings_dialog(ui, work, table);
    }
}

// The source of each foreign metric, or its error, with a link that removes it.
void draw_foreign(Ui& ui, Comparing& comparing, const Comparison& comparison) {
    std::string gone;
    ImGui::PushFont(ui.theme.fonts.small);
    for (const ForeignMetric& one : comparing.foreign) {
        dim_text(ui, shortened(ui.theme.fonts.small, one.key + ": " + one.from,
                               0.8F * ImGui::GetContentRegionAvail().x));
        ImGui::SameLine();
        if (link(ui, {.id = "remove metric:" + one.key, .label = "Remove"})) gone = one.key;
    }
    for (const std::string& fault : comparison.failed) {
        reading_text(ui, ui.theme.warning,
                     {.id = "compare:failed", .text = fault + ".", .value = fault});
    }
    ImGui::PopFont();
    if (!gone.empty()) remove_metric(comparing, gone);
}

// Ratings belong to the patterns that were felt: names those that have changed or are gone.
void draw_versions(Ui& ui, const PatternSet& set, const RatedPeople& people) {
    const std::string edited = words_on_edited(people.edited);
    const std::string gone = words_on_gone(people.gone);
    const auto say_of = [&](const char* id, const std::string& words) {
        if (words.empty()) return;
        reading_text(ui, ui.theme.warning, {.id = id, .text = words + ".", .value = words});
    };
    say_of("compare:edited", edited);
    say_of("compare:gone", gone);
    const bool is_recorded =
        std::ranges::any_of(set.ratings, [](const Ratings& one) { return !one.versions.empty(); });
    if (is_recorded) return;
    dim_text(ui,
             {.id = "compare:unrecorded", .text = "Version of the rated patterns: not recorded."});
}

// Facts that hold for all metrics: the raters, their reliability, chance.
void draw_people(Ui& ui, const Comparison& comparison) {
    const RatedPeople& people = comparison.people->said;
    const AlienationChance& chance = people.rated.k_chance;
    const PatternSet& set = *comparison.request.map->request.set;
    const std::string text =
        people_text(set, people) + ". K by chance " + with_decimals(chance.mean, 2) + " (" +
        with_decimals(chance.middle.low, 2) + " to " + with_decimals(chance.middle.high, 2) + ").";
    std::string ceiling = ceiling_text(people.reliability, people.mark);
    const std::string single = single_ceiling_text(people.ceilings, people.mark);
    if (!single.empty()) ceiling += " " + single;
    const std::string unrated = remark_on_unrated(people.unrated, set.vibrations.size());
    ImGui::PushFont(ui.theme.fonts.small);
    reading_text(ui, words_of(people.mark).empty() ? ui.theme.dim_text : ui.theme.warning,
                 {.id = "compare:people", .text = text});
    draw_versions(ui, set, people);
    if (!unrated.empty()) {
        reading_text(ui, ui.theme.warning,
                     {.id = "compare:unrated", .text = unrated + ".", .value = unrated});
    }
    reading_text(ui, ui.theme.dim_text, {.id = "compare:ceiling", .text = ceiling});
    ImGui::PopFont();
}

// Details of the chosen row: its pairs against the ratings; without ratings, the fit of its map.
void draw_chosen_metric(Ui& ui, Workspace& work, const ShownMap& shown_map, Comparing& comparing,
                        const Comparison& comparison, Rect area) {
    const Fonts& fonts = ui.theme.fonts;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const std::string& name = metric_of_key(comparison, comparing.panel.metric).name;
    const bool has_people = comparison.people.has_value();
    const char* what = has_people ? "pair by pair" : "how well its map keeps its order";
    draw_text(list, fonts.semibold, area.min, ui.theme.text, name);
    const float used = text_size(fonts.semibold, name).x + ui.theme.gap_px;
    const float lower = 0.8F * (text_size(fonts.semibold, "0").y - text_size(fonts.small, "0").y);
    draw_text(list, fonts.small, area.min + ImVec2{used, lower}, ui.theme.dim_text,
              shortened(fonts.small, what, std::max(0.0F, area.width() - used)));
    area.min.y += ImGui::GetTextLineHeightWithSpacing();
    if (has_people) return draw_pairs_scatter(ui, work, shown_map, comparing, comparison, area);
    draw_shepard_diagram(ui, work, shown_map, comparing, area);
}

void draw_table_view(Ui& ui, Workspace& work, const ShownMap& shown_map, Comparing& comparing,
                     const Comparison& comparison) {
    const std::string verdict = verdict_on_pm(comparison);
    if (!verdict.empty()) {
        reading_text(ui, ui.theme.warning, {.id = "compare:verdict", .text = verdict});
    }
    const Rect area = rest_of_pane();
    if (area.empty()) return;
    const float s = ui.theme.scale;
    const float row_px = ImGui::GetTextLineHeight() + 2.0F * ImGui::GetStyle().CellPadding.y;
    const bool has_people = comparison.people.has_value();
    // Heading and rows; with ratings, remarks follow.
    const float lines =
        2.0F + static_cast<float>(comparison.metrics.size()) + (has_people ? 4.0F : 0.0F);
    const WordsWanted table{(has_people ? 420.0F : 220.0F) * s, (has_people ? 640.0F : 420.0F) * s,
                            lines * row_px};
    const WordsAndPicture parts =
        words_and_picture(area, table, {300.0F * s, 260.0F * s}, 2.0F * ui.theme.gap_px);
    draw_metric_table(ui, comparing, comparison, parts.words);
    if (parts.picture.empty()) return;
    draw_chosen_metric(ui, work, shown_map, comparing, comparison, parts.picture);
}

// Ratings belong to intended patterns: with twins, either side can be compared with them.
void draw_sides(Ui& ui, Workspace& work) {
    const bool has_twins = std::ranges::any_of(work.document.set.vibrations, measures_another);
    if (shown_side(work) != Side::both || !has_twins) return;
    reading_text(ui.theme.dim_text,
                 "Patterns and their measured twins are shown together. Compare either side with "
                 "the ratings of the patterns:");
    if (button(ui, {.id = "button:intended only", .label = "Intended only"}))
        show_side(work, Side::intended);
    flow_on(button_width("Measured only"), ui.theme.gap_px);
    if (button(ui, {.id = "button:measured only", .label = "Measured only"}))
        show_side(work, Side::measured);
}

void draw_no_ratings(Ui& ui, Workspace& work, TableState& table, const Comparison& comparison) {
    if (!comparison.fault.empty()) {
        reading_text(ui, ui.theme.warning,
                     {.id = "compare:fault",
                      .text = "The ratings do not fit the set: " + comparison.fault,
                      .value = comparison.fault});
        return draw_sides(ui, work);
    }
    reading_text(
        ui.theme.text,
        "What did people say of these patterns? With their ratings this table tells which metric "
        "agrees with them best. Until then it shows how much each agrees with PM.");
    if (button(ui, {.id = "button:load ratings", .label = "Load ratings..."}))
        load_ratings_dialog(ui, work, table);
}

void draw_comparing(Ui& ui, const Workspace& work, Comparing& comparing) {
    if (!comparing.comparison_job.busy()) return;
    if (draw_progress(ui, {"Comparing", comparing.comparison_job.progress(), "comparison"}))
        cancel_comparison(work, comparing);
}

}  // namespace

bool draw_comparison_state(Ui& ui, const Workspace& work, const ShownMap& shown_map,
                           Comparing& comparing) {
    const ShownComparison shown = shown_comparison(work, shown_map, comparing);
    const bool few = work.document.set.vibrations.size() < 2;
    if (!few && comparison_waits(work, comparing) && !shown.is_computing && shown.is_stale) {
        ImGui::TextWrapped("%s metrics of every pair and their maps: this may take a while.",
                           std::to_string(kMetricCount).c_str());
        if (primary_button(ui, {.id = "button:compare metrics", .label = "Compare metrics"}))
            ask_for_comparison(work, comparing);
    }
    draw_comparing(ui, work, comparing);
    const bool failed = draw_failure(ui, "compare", comparing.comparison_job.failure());
    if (shown.comparison && !few) return true;
    if (failed) return false;
    const Rect area = rest_of_pane();
    if (area.empty()) return false;
    const std::string each =
        std::to_string(kMetricCount) + " metrics of every pair, and a map of each.";
    draw_empty(*ImGui::GetWindowDrawList(), ui.theme, area,
               few                  ? "No pairs to compare"
               : shown.is_computing ? "Comparing"
                                    : "Nothing compared yet",
               few                  ? "It takes two patterns to be alike or far apart."
               : shown.is_computing ? each.c_str()
                                    : "The metrics are compared once the space above is exact.");
    return false;
}

void draw_compare_panel(Ui& ui, Workspace& work, Layout& layout, const ShownMap& shown_map,
                        TableState& table, Comparing& comparing) {
    draw_views(ui, work, table, comparing);
    ImGui::Dummy({1.0F, 1.0F});
    if (comparing.panel.view == CompareView::findings)
        return draw_findings(ui, comparing, rest_of_pane());
    if (!draw_comparison_state(ui, work, shown_map, comparing)) return;
    // Kept alive while it is drawn.
    const std::shared_ptr<const Comparison> comparison = comparing.comparison;
    draw_foreign(ui, comparing, *comparison);
    if (comparison->people && !work.document.set.ratings.empty()) {
        draw_people(ui, *comparison);
        if (!comparison->people->said.unrated.empty()) draw_sides(ui, work);
    }
    const bool is_table = comparing.panel.view == CompareView::table;
    if (!comparison->people && (is_table || !comparison->fault.empty())) {
        draw_no_ratings(ui, work, table, *comparison);
    }
    if (is_table) return draw_table_view(ui, work, shown_map, comparing, *comparison);
    draw_compared_pairs(ui, work, layout, shown_map, table, comparing, *comparison);
}

}  // namespace tact
