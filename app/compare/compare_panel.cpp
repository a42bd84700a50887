// Metrics beside what people said: the table, the pairs that disagree, and the paper's findings.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "app/compare/compare_follow.h"
#include "app/compare/compare_panels.h"
#include "app/compare/metric_choice.h"
#include "app/compare/people_text.h"
#include "app/compare/reading_text.h"
#include "app/document/rating_files.h"
#include "app/document/shown_side.h"
#include "app/measured/import_follow.h"
#include "app/progress/failure.h"
#include "app/progress/progress_line.h"
#include "app/ui/widgets.h"
#include "viz/charts/scatter_view.h"
#include "viz/drawing/marks.h"
#include "viz/drawing/plot.h"
#include "viz/drawing/words_and_picture.h"

namespace tact {

namespace {

// Ratings can be loaded from here unless a button below offers it.
bool offers_below(const Workspace& work, const Comparing& comparing) {
    const bool is_table = comparing.panel.view == CompareView::table;
    if (comparing.panel.view == CompareView::findings || !comparing.comparison) return false;
    if (work.document.set.vibrations.size() < 2 || comparing.comparison->people) return false;
    return !is_table || comparing.comparison->fault.empty();
}

void draw_views(Ui& ui, const Workspace& work, Comparing& comparing) {
    const float gap = 2.0F * ui.theme.scale;
    const auto view = [&](CompareView which, const char* name) {
        if (draw_chip(ui, name, name, comparing.panel.view == which)) comparing.panel.view = which;
        note_item(ui.rects, std::string("compare:") + name);
    };
    view(CompareView::table, "Table");
    flow_on(chip_width(ui, "Pairs"), gap);
    view(CompareView::scatter, "Pairs");
    flow_on(chip_width(ui, "Findings"), gap);
    view(CompareView::findings, "Findings");
    if (offers_below(work, comparing)) return;
    flow_on(ImGui::CalcTextSize("Load ratings...").x, 2.0F * ui.theme.gap_px);
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    ImGui::SetCursorScreenPos({corner.x, corner.y + 2.0F * ui.theme.scale});
    if (link(ui, "load ratings", "Load ratings...")) load_ratings_dialog(ui, work);
    note_item(ui.rects, "link:load ratings");
    draw_tooltip(ui,
                 "A CSV of what people said of these patterns: a square with names, or a line a "
                 "rating with the participant. Names must be those of the patterns.");
}

// What is the same for all metrics: who was asked, how far they can be relied on, chance.
void draw_people(Ui& ui, const Comparison& comparison) {
    const RatedPeople& people = comparison.people->said;
    const AlienationChance& chance = people.rated.k_chance;
    const PatternSet& set = *comparison.request.map->request.set;
    const std::string text = people_text(set, people) + ". K by chance " + digits(chance.mean, 2) +
                             " (" + digits(chance.middle.low, 2) + " to " +
                             digits(chance.middle.high, 2) + ").";
    std::string ceiling = ceiling_text(people.reliability, people.synthetic);
    const std::string single = single_ceiling_text(people.ceilings, people.synthetic);
    if (!single.empty()) ceiling += " " + single;
    const std::string unrated = remark_on_unrated(people.unrated, set.vibrations.size());
    ImGui::PushFont(ui.theme.fonts.small);
    reading_text(people.synthetic ? ui.theme.warning : ui.theme.dim_text, text);
    note_item(ui.rects, "compare:people", text);
    if (!unrated.empty()) {
        reading_text(ui.theme.warning, unrated + ".");
        note_item(ui.rects, "compare:unrated", unrated);
    }
    reading_text(ui.theme.dim_text, ceiling);
    note_item(ui.rects, "compare:ceiling", ceiling);
    ImGui::PopFont();
}

// The best of a column among the defined values.
struct Best {
    double rho = -2.0;
    double rho_p = 2.0;
    double k = 2.0;
    double k_p = 2.0;
};

Best best_of(const Comparison& comparison) {
    Best best;
    for (const ComparedMetric& row : comparison.metrics) {
        if (!row.evaluation) continue;
        best.rho = std::fmax(best.rho, row.evaluation->rho);
        best.rho_p = std::fmin(best.rho_p, row.evaluation->rho_p);
        best.k = std::fmin(best.k, row.evaluation->k);
        best.k_p = std::fmin(best.k_p, row.evaluation->k_p);
    }
    return best;
}

// The best stands on a ground of its own. Where many share it, as with the least p of so many
// draws, they are in bold alone.
enum class Mark { none, best, shared };

void draw_cell(const Ui& ui, const std::string& text, Mark mark) {
    ImGui::TableNextColumn();
    if (mark != Mark::none) ImGui::PushFont(ui.theme.fonts.semibold);
    if (mark == Mark::best) ImGui::TableSetBgColor(ImGuiTableBgTarget_CellBg, ui.theme.hover);
    right_aligned(text);
    if (mark != Mark::none) ImGui::PopFont();
}

// All digits: what a test holds against the command line.
std::string row_value(const ComparedMetric& row) {
    if (!row.evaluation) return digits(row.rho_with_pm, 17);
    const Evaluation& e = *row.evaluation;
    std::string text;
    for (const double value :
         {e.rho, e.rho_interval.low, e.rho_interval.high, e.rho_p, e.k, e.k_p}) {
        char cell[40];
        std::snprintf(cell, sizeof cell, "%.17g ", value);
        text += cell;
    }
    return text;
}

std::string interval_text(const Evaluation& e) {
    return digits(e.rho_interval.low, 2) + " to " + digits(e.rho_interval.high, 2);
}

std::string tip_of(const ComparedMetric& row, bool synthetic) {
    std::string tip = metric_help(row.metric);
    if (!row.evaluation) return tip;
    const Evaluation& e = *row.evaluation;
    tip += "\n" + of_people("rho ", synthetic) + digits(e.rho, 2) + ", 95 % " + interval_text(e) +
           ", p of K " + digits(e.k_p, 4) + ".\n" + of_people("tau-b ", synthetic) +
           digits(e.tau_b, 3) + ", K over maps that fit as well " + digits(e.k_spread.low, 2) +
           " to " + digits(e.k_spread.high, 2) + ", 1 - K/chance " + digits(e.k_corrected, 2) +
           ", stress-1 " + digits(e.stress1, 3);
    for (const std::string& remark : e.remarks) tip += "\n" + remark;
    return tip;
}

// Without people two columns; with people as many as there is room for. What is left out the
// tooltip of a row tells.
enum class Columns { few, least, most, all };

void draw_row(Ui& ui, Comparing& comparing, const ComparedMetric& row, const Best& best,
              bool synthetic) {
    const MetricTraits& metric = traits(row.metric);
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    const float room = ImGui::GetContentRegionAvail().x;
    if (ImGui::Selectable(metric.name, comparing.panel.metric == row.metric,
                          ImGuiSelectableFlags_SpanAllColumns)) {
        comparing.panel.metric = row.metric;
        comparing.panel.shepard_of_people = false;
    }
    note_item(ui.rects, std::string("metric:") + metric.key, row_value(row));
    draw_tooltip(ui, tip_of(row, synthetic).c_str());
    constexpr const char* kOurs = "ours";
    const float beside = ImGui::CalcTextSize(metric.name).x + ImGui::GetStyle().ItemSpacing.x +
                         text_size(ui.theme.fonts.small, kOurs).x;
    if (metric.is_reference && beside <= room) {
        ImGui::SameLine();
        ImGui::PushFont(ui.theme.fonts.small);
        dim_text(ui, kOurs);
        ImGui::PopFont();
        note_item(ui.rects, std::string("ours:") + metric.key);
    }
    if (row.evaluation) {
        const Evaluation& e = *row.evaluation;
        const auto best_if = [](bool is_best, Mark mark) { return is_best ? mark : Mark::none; };
        draw_cell(ui, digits(e.rho, 2), best_if(e.rho == best.rho, Mark::best));
        draw_cell(ui, interval_text(e), Mark::none);
        draw_cell(ui, digits(e.rho_p, 4), best_if(e.rho_p == best.rho_p, Mark::shared));
        draw_cell(ui, e.is_failed_map ? "no map" : digits(e.k, 2),
                  best_if(e.k == best.k, Mark::best));
        draw_cell(ui, digits(e.k_p, 4), best_if(e.k_p == best.k_p, Mark::shared));
    }
    draw_cell(ui, digits(row.rho_with_pm, 2), Mark::none);
}

void draw_head(Ui& ui, Columns columns, bool synthetic) {
    struct Column {
        const char* name;
        const char* tip;
        Columns from;  // on; without people the first and the last
        float weight;
    };
    constexpr std::array<Column, 7> kColumns{
        {{"metric", "Click one for its pairs and its Shepard diagram.", Columns::least, 2.4F},
         {"rho",
          "Spearman's rank correlation with the ratings, pair by pair: 1 the same order. Bold: the "
          "highest.",
          Columns::least, 1.0F},
         {"95 %", "Interval of rho if other patterns had been drawn: bootstrap over patterns.",
          Columns::all, 1.6F},
         {"p",
          "How often patterns under exchanged names agree as well: Mantel's test. Bold: the least, "
          "which many share where no draw agreed as well.",
          Columns::all, 1.0F},
         {"K",
          "Alienation of the two maps: 0 one shape; unrelated maps have about .5, not 1. Bold: the "
          "lowest.",
          Columns::least, 1.0F},
         {"p of K",
          "How often maps under exchanged names are as close in shape. Bold: the least, which many "
          "share where no draw came as close.",
          Columns::all, 1.0F},
         {"with PM", "Spearman's rank correlation with PM: how much the metric is another one.",
          Columns::most, 1.0F}}};
    const auto is_left_out = [&](const Column& column) {
        return columns == Columns::few && &column != &kColumns.front() &&
               &column != &kColumns.back();
    };
    ImGui::TableSetupScrollFreeze(1, 1);
    for (const Column& column : kColumns) {
        if (is_left_out(column)) continue;
        const bool is_shown = columns == Columns::few || column.from <= columns;
        const ImGuiTableColumnFlags shown = is_shown ? 0 : ImGuiTableColumnFlags_Disabled;
        ImGui::TableSetupColumn(column.name, ImGuiTableColumnFlags_WidthStretch | shown,
                                column.weight);
    }
    ImGui::TableNextRow(ImGuiTableRowFlags_Headers);
    ImGui::PushFont(ui.theme.fonts.small);
    for (const Column& column : kColumns) {
        if (is_left_out(column)) continue;
        ImGui::TableNextColumn();
        // An interval and a p stand to the right of what they belong to.
        const std::string name = column.name;
        const bool labelled = synthetic && (name == "rho" || name == "K");
        const bool is_with_pm = &column == &kColumns.back();
        // Columns are narrow: what it is of stands below.
        const char* below = labelled ? "synthetic" : is_with_pm ? "with PM" : "";
        const auto head = [&](const std::string& words, bool is_left) {
            ImGui::PushStyleColor(ImGuiCol_Text, ui.theme.dim_text);
            is_left ? ImGui::TextUnformatted(words.c_str()) : right_aligned(words);
            ImGui::PopStyleColor();
        };
        ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(0.0F, 0.0F));
        head(is_with_pm ? "rho" : name, &column == &kColumns.front());
        note_item(ui.rects, "compare:head " + name, of_people(name, labelled));
        draw_tooltip(ui, column.tip);
        if (*below != '\0') {
            head(below, false);
            draw_tooltip(ui, column.tip);
        }
        ImGui::PopStyleVar();
    }
    ImGui::PopFont();
}

void draw_remarks(Ui& ui, const Comparison& comparison) {
    ImGui::PushFont(ui.theme.fonts.small);
    std::string all;
    for (const ComparedMetric& row : comparison.metrics) {
        if (!row.evaluation) continue;
        for (const std::string& remark : row.evaluation->remarks) {
            all += std::string(all.empty() ? "" : "\n") + traits(row.metric).name + ": " + remark;
        }
    }
    if (comparison.people && comparison.request.map->prediction.pm.size <= 7) {
        all += std::string(all.empty() ? "" : "\n") +
               "So few patterns fit any map: K and stress say little.";
    }
    if (!all.empty()) {
        reading_text(ui.theme.dim_text, all);
        note_item(ui.rects, "compare:remarks", all.substr(0, all.find('\n')));
    }
    ImGui::PopFont();
}

void draw_table(Ui& ui, Comparing& comparing, const Comparison& comparison, const Rect& area) {
    const bool synthetic = has_nobody(comparison);
    const float room = area.width() / ui.theme.scale;
    const Columns columns = !comparison.people ? Columns::few
                            : room >= 560.0F   ? Columns::all
                            : room >= 300.0F   ? Columns::most
                                               : Columns::least;
    const Best best = best_of(comparison);
    ImGui::SetCursorScreenPos(area.min);
    ImGui::BeginChild("metrics", area.size());
    constexpr ImGuiTableFlags kFlags =
        ImGuiTableFlags_SizingStretchProp | ImGuiTableFlags_RowBg | ImGuiTableFlags_NoSavedSettings;
    if (ImGui::BeginTable("metrics", comparison.people ? 7 : 2, kFlags)) {
        draw_head(ui, columns, synthetic);
        for (const ComparedMetric& row : comparison.metrics) {
            draw_row(ui, comparing, row, best, synthetic);
        }
        ImGui::EndTable();
    }
    draw_remarks(ui, comparison);
    ImGui::EndChild();
}

// What the chosen row is made of: its pairs against the ratings, without any how well its map fits.
void draw_chosen_metric(Ui& ui, Workspace& work, const ShownMap& shown_map, Comparing& comparing,
                        const Comparison& comparison, Rect area) {
    const Fonts& fonts = ui.theme.fonts;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const std::string name = traits(comparing.panel.metric).name;
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
        reading_text(ui.theme.warning, verdict);
        note_item(ui.rects, "compare:verdict", verdict);
    }
    const Rect area = rest_of_pane();
    if (area.empty()) return;
    const float s = ui.theme.scale;
    const float row_px = ImGui::GetTextLineHeight() + 2.0F * ImGui::GetStyle().CellPadding.y;
    const bool has_people = comparison.people.has_value();
    // Head and rows; with people remarks follow.
    const float lines =
        2.0F + static_cast<float>(comparison.metrics.size()) + (has_people ? 4.0F : 0.0F);
    const WordsWanted table{(has_people ? 420.0F : 220.0F) * s, (has_people ? 640.0F : 420.0F) * s,
                            lines * row_px};
    const WordsAndPicture parts =
        words_and_picture(area, table, {300.0F * s, 260.0F * s}, 2.0F * ui.theme.gap_px);
    draw_table(ui, comparing, comparison, parts.words);
    if (parts.picture.empty()) return;
    draw_chosen_metric(ui, work, shown_map, comparing, comparison, parts.picture);
}

// People rate intended patterns: beside their twins each of the two sides can be held against that.
void draw_sides(Ui& ui, Workspace& work) {
    const bool has_twins = std::ranges::any_of(work.document.set.vibrations, measures_another);
    if (shown_side(work) != Side::both || !has_twins) return;
    reading_text(ui.theme.dim_text,
                 "Patterns and their measured twins are shown together. Compare either side with "
                 "the ratings of the patterns:");
    if (ImGui::Button("Intended only")) show_side(work, Side::intended);
    note_item(ui.rects, "button:intended only");
    flow_on(button_width("Measured only"), ui.theme.gap_px);
    if (ImGui::Button("Measured only")) show_side(work, Side::measured);
    note_item(ui.rects, "button:measured only");
}

void draw_no_ratings(Ui& ui, Workspace& work, const Comparison& comparison) {
    if (!comparison.fault.empty()) {
        reading_text(ui.theme.warning, "The ratings do not fit the set: " + comparison.fault);
        note_item(ui.rects, "compare:fault", comparison.fault);
        return draw_sides(ui, work);
    }
    reading_text(
        ui.theme.text,
        "What did people say of these patterns? With their ratings this table tells which metric "
        "agrees with them best. Until then: how much each agrees with PM.");
    if (ImGui::Button("Load ratings...")) load_ratings_dialog(ui, work);
    note_item(ui.rects, "button:load ratings");
}

void draw_comparing(Ui& ui, const Workspace& work, Comparing& comparing) {
    if (!comparing.comparison_job || !comparing.comparison_job->busy()) return;
    if (draw_progress(ui, {"Comparing", comparing.comparison_job->progress(), "comparison"}))
        cancel_comparison(work, comparing);
}

}  // namespace

bool draw_comparison_state(Ui& ui, const Workspace& work, const ShownMap& shown_map,
                           Comparing& comparing) {
    const ShownComparison shown = shown_comparison(work, shown_map, comparing);
    const bool few = work.document.set.vibrations.size() < 2;
    if (!few && comparison_waits(work, comparing) && !shown.is_computing && shown.is_stale) {
        ImGui::TextWrapped("Thirteen metrics of every pair and their maps: this may take a while.");
        if (ImGui::Button("Compare metrics")) ask_for_comparison(work, comparing);
        note_item(ui.rects, "button:compare metrics");
    }
    draw_comparing(ui, work, comparing);
    const bool failed = draw_failure(ui, "compare", failure_of(comparing.comparison_job));
    if (shown.comparison && !few) return true;
    if (failed) return false;
    const Rect area = rest_of_pane();
    if (area.empty()) return false;
    draw_empty(*ImGui::GetWindowDrawList(), ui.theme, area,
               few                  ? "No pairs to compare"
               : shown.is_computing ? "Comparing"
                                    : "Nothing compared yet",
               few                  ? "It takes two patterns to be alike or far apart."
               : shown.is_computing ? "Thirteen metrics of every pair, and a map of each."
                                    : "The metrics are compared once the space above is exact.");
    return false;
}

void draw_compare_panel(Ui& ui, Workspace& work, Layout& layout, const ShownMap& shown_map,
                        Comparing& comparing) {
    draw_views(ui, work, comparing);
    ImGui::Dummy({1.0F, 1.0F});
    if (comparing.panel.view == CompareView::findings)
        return draw_findings(ui, comparing, rest_of_pane());
    if (!draw_comparison_state(ui, work, shown_map, comparing)) return;
    // Kept while it is drawn.
    const std::shared_ptr<const Comparison> comparison = comparing.comparison;
    if (comparison->people && !work.document.set.ratings.empty()) {
        draw_people(ui, *comparison);
        if (!comparison->people->said.unrated.empty()) draw_sides(ui, work);
    }
    const bool is_table = comparing.panel.view == CompareView::table;
    if (!comparison->people && (is_table || !comparison->fault.empty())) {
        draw_no_ratings(ui, work, *comparison);
    }
    if (is_table) return draw_table_view(ui, work, shown_map, comparing, *comparison);
    draw_compared_pairs(ui, work, layout, shown_map, comparing, *comparison);
}

}  // namespace tact
