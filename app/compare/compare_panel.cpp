// Metrics beside what people said: the table, the pairs that disagree, and the paper's findings.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <set>

#include "app/compare/bench_follow.h"
#include "app/compare/compare_panels.h"
#include "app/compare/metric_choice.h"
#include "app/document/rating_files.h"
#include "app/document/shown_side.h"
#include "app/measured/import_follow.h"
#include "app/ui/widgets.h"
#include "viz/charts/scatter_view.h"
#include "viz/drawing/marks.h"
#include "viz/drawing/plot.h"

namespace tact {

namespace {

std::string digits(double value, int decimals) {
    if (std::isnan(value)) return "\u2013";
    char text[48];
    std::snprintf(text, sizeof text, "%.*f", decimals, value);
    std::string result = text;
    if (result.front() == '-') result.replace(0, 1, "\u2212");
    return result;
}

void draw_views(App& app) {
    const float gap = 2.0F * app.theme.scale;
    const auto view = [&app](CompareView which, const char* name) {
        if (draw_chip(app, name, name, app.compare.view == which)) app.compare.view = which;
        note_item(app.rects, std::string("compare:") + name);
    };
    view(CompareView::table, "Table");
    flow_on(chip_width(app, "Pairs"), gap);
    view(CompareView::scatter, "Pairs");
    flow_on(chip_width(app, "Findings"), gap);
    view(CompareView::findings, "Findings");
    flow_on(ImGui::CalcTextSize("Load ratings...").x, 2.0F * app.theme.gap_px);
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    ImGui::SetCursorScreenPos({corner.x, corner.y + 2.0F * app.theme.scale});
    if (link(app, "load ratings", "Load ratings...")) load_ratings_dialog(app);
    note_item(app.rects, "link:load ratings");
    draw_tooltip(app,
                 "A CSV of what people said of these patterns: a square with names, or a line a "
                 "rating with the participant. Names must be those of the patterns.");
}

std::string people_text(const App& app) {
    const auto& ratings = app.document.set.ratings;
    std::set<std::string> voices;
    for (const Ratings& one : ratings) voices.insert(one.name);
    std::string text = ratings.front().file.empty() ? "Ratings of the set" : ratings.front().file;
    text += voices.size() == 1 ? ": 1 participant" : ": " + std::to_string(voices.size());
    if (voices.size() > 1) text += " participants";
    if (ratings.size() > voices.size()) text += ", " + std::to_string(ratings.size()) + " passes";
    return text;
}

// What is the same for all metrics: who was asked, how far they can be relied on, chance.
void draw_people(App& app, const Comparison& comparison) {
    const RatedPeople& people = comparison.people->said;
    const std::size_t pairs = people.rated.people.dissimilarity.condensed.size();
    std::string text = people_text(app) + ", " + std::to_string(people.rated_pairs) + " of " +
                       std::to_string(pairs) + " pairs. ";
    const AlienationChance& chance = people.rated.k_chance;
    text += "K by chance " + digits(chance.mean, 2) + " (" + digits(chance.middle.low, 2) + " to " +
            digits(chance.middle.high, 2) + ").";
    const Reliability& reliability = people.reliability;
    std::string ceiling = "Noise ceiling unknown: it takes two voices.";
    if (reliability.voices > 1) {
        ceiling = "Noise ceiling: rho " + digits(reliability.one_with_others, 2) +
                  " of one voice with the others; reliability of their mean " +
                  digits(reliability.spearman_brown, 2) + ".";
    }
    ImGui::PushFont(app.theme.fonts.small);
    coloured_text(app.theme.dim_text, text);
    note_item(app.rects, "compare:people", text);
    coloured_text(app.theme.dim_text, ceiling);
    note_item(app.rects, "compare:ceiling", ceiling);
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

// Where many share the best, as with the least p of so many draws, they are in bold alone.
enum class Mark { none, best, shared };

void draw_cell(const App& app, const std::string& text, Mark mark) {
    ImGui::TableNextColumn();
    if (mark != Mark::none) ImGui::PushFont(app.theme.fonts.semibold);
    if (mark == Mark::best) ImGui::PushStyleColor(ImGuiCol_Text, app.theme.accent);
    ImGui::TextUnformatted(text.c_str());
    if (mark == Mark::best) ImGui::PopStyleColor();
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

std::string tip_of(const ComparedMetric& row) {
    const MetricTraits& metric = traits(row.metric);
    std::string tip = std::string(metric.name) + ": " + metric.description + ". " + metric.source;
    if (!row.evaluation) return tip + ".";
    const Evaluation& e = *row.evaluation;
    tip += ".\ntau-b " + digits(e.tau_b, 3) + ", K over maps that fit as well " +
           digits(e.k_spread.low, 2) + " to " + digits(e.k_spread.high, 2) + ", 1 - K/chance " +
           digits(e.k_corrected, 2) + ", stress-1 " + digits(e.stress1, 3);
    for (const std::string& remark : e.remarks) tip += "\n" + remark;
    return tip;
}

void draw_row(App& app, const ComparedMetric& row, const Best& best) {
    const MetricTraits& metric = traits(row.metric);
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    if (ImGui::Selectable(metric.name, app.compare.metric == row.metric,
                          ImGuiSelectableFlags_SpanAllColumns)) {
        app.compare.metric = row.metric;
        app.compare.shepard_of_people = false;
    }
    note_item(app.rects, std::string("metric:") + metric.key, row_value(row));
    draw_tooltip(app, tip_of(row).c_str());
    if (metric.is_reference) {
        ImGui::SameLine();
        ImGui::PushFont(app.theme.fonts.small);
        dim_text(app, "ours");
        ImGui::PopFont();
    }
    if (row.evaluation) {
        const Evaluation& e = *row.evaluation;
        const auto best_if = [](bool is_best, Mark mark) { return is_best ? mark : Mark::none; };
        draw_cell(app, digits(e.rho, 2), best_if(e.rho == best.rho, Mark::best));
        draw_cell(app, digits(e.rho_interval.low, 2) + " to " + digits(e.rho_interval.high, 2),
                  Mark::none);
        draw_cell(app, digits(e.rho_p, 4), best_if(e.rho_p == best.rho_p, Mark::shared));
        draw_cell(app, e.is_failed_map ? "no map" : digits(e.k, 2),
                  best_if(e.k == best.k, Mark::best));
        draw_cell(app, digits(e.k_p, 4), best_if(e.k_p == best.k_p, Mark::shared));
    }
    draw_cell(app, digits(row.rho_with_pm, 2), Mark::none);
}

void draw_head(const App& app, bool has_people) {
    struct Column {
        const char* name;
        const char* tip;
        bool of_people;
    };
    constexpr std::array<Column, 7> kColumns{
        {{"metric", "Click one for its pairs and its Shepard diagram.", false},
         {"rho", "Spearman's rank correlation with the ratings, pair by pair: 1 the same order.",
          true},
         {"95 %", "Interval of rho if other patterns had been drawn: bootstrap over patterns.",
          true},
         {"p", "How often patterns under exchanged names agree as well: Mantel's test.", true},
         {"K", "Alienation of the two maps: 0 one shape; unrelated maps have about .5, not 1.",
          true},
         {"p of K", "How often maps under exchanged names are as close in shape.", true},
         {"with PM", "Spearman's rank correlation with PM: how much the metric is another one.",
          false}}};
    ImGui::TableSetupScrollFreeze(1, 1);
    for (const Column& column : kColumns) {
        if (has_people || !column.of_people) ImGui::TableSetupColumn(column.name);
    }
    ImGui::TableNextRow(ImGuiTableRowFlags_Headers);
    ImGui::PushFont(app.theme.fonts.small);
    for (const Column& column : kColumns) {
        if (!has_people && column.of_people) continue;
        ImGui::TableNextColumn();
        dim_text(app, column.name);
        draw_tooltip(app, column.tip);
    }
    ImGui::PopFont();
}

void draw_remarks(App& app, const Comparison& comparison) {
    ImGui::PushFont(app.theme.fonts.small);
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
        coloured_text(app.theme.dim_text, all);
        note_item(app.rects, "compare:remarks", all.substr(0, all.find('\n')));
    }
    ImGui::PopFont();
}

void draw_table(App& app, const Comparison& comparison) {
    const std::string verdict = verdict_on_pm(comparison);
    if (!verdict.empty()) {
        coloured_text(app.theme.warning, verdict);
        note_item(app.rects, "compare:verdict", verdict);
    }
    const bool has_people = comparison.people.has_value();
    const Best best = best_of(comparison);
    ImGui::BeginChild("metrics", ImGui::GetContentRegionAvail());
    constexpr ImGuiTableFlags kFlags =
        ImGuiTableFlags_SizingStretchProp | ImGuiTableFlags_RowBg | ImGuiTableFlags_NoSavedSettings;
    if (ImGui::BeginTable("metrics", has_people ? 7 : 2, kFlags)) {
        draw_head(app, has_people);
        for (const ComparedMetric& row : comparison.metrics) draw_row(app, row, best);
        ImGui::EndTable();
    }
    draw_remarks(app, comparison);
    ImGui::EndChild();
}

void draw_disagreement(App& app, const Comparison& comparison, const Disagreement& apart) {
    const auto& vibrations = comparison.request.map->request.set->vibrations;
    const auto [i, j] = pair_at(vibrations.size(), apart.pair);
    const std::string names = vibrations[i].name + " \u2013 " + vibrations[j].name;
    const bool closer = apart.ratings_rank < apart.metric_rank;
    ImGui::PushID(static_cast<int>(apart.pair));
    if (ImGui::Selectable(names.c_str())) {
        choose_pair(app, i, j);
        app.bench = BenchTab::why;
    }
    note_item(app.rects, "disagreement:" + vibrations[i].name + "|" + vibrations[j].name);
    draw_tooltip(app, "Why does the model tell them as it does?");
    ImGui::PushFont(app.theme.fonts.small);
    dim_text(app, std::string(closer ? "felt closer" : "felt farther") + ": rank " +
                      significant(apart.ratings_rank) + ", predicted " +
                      significant(apart.metric_rank));
    ImGui::PopFont();
    ImGui::PopID();
}

void draw_list(App& app, const Comparison& comparison, const ComparedMetric& row,
               const Rect& area) {
    ImGui::SetCursorScreenPos(area.min);
    ImGui::BeginChild("disagreements", area.size());
    ImGui::PushFont(app.theme.fonts.semibold);
    ImGui::TextUnformatted("Farthest apart");
    ImGui::PopFont();
    for (const Disagreement& apart : row.farthest) draw_disagreement(app, comparison, apart);
    ImGui::EndChild();
}

void draw_pairs(App& app, const Comparison& comparison) {
    draw_metric_choice(app, false);
    const Rect area = rest_of_pane();
    if (area.width() < 40.0F || area.height() < 40.0F) return;
    if (!comparison.people) {
        draw_empty(*ImGui::GetWindowDrawList(), app.theme, area, "No ratings to compare with",
                   "Load what people said: each pair is then a point, prediction against rating.");
        return;
    }
    const ComparedMetric& row = comparison.metrics[static_cast<std::size_t>(app.compare.metric)];
    const Dissimilarity& people = comparison.people->said.rated.people.dissimilarity;
    const std::vector<double>& rank = row.ranks;
    const float list_px = std::min(0.42F * area.width(), 220.0F * app.theme.scale);
    const Rect left{area.min, {area.max.x - list_px - app.theme.gap_px, area.max.y}};
    const std::string corner = "rho " + digits(row.evaluation->rho, 2);
    const std::string x_title = std::string("rank by ") + traits(row.metric).name;
    const auto& vibrations = comparison.request.map->request.set->vibrations;
    ScatterScene scene;
    scene.x = rank;
    scene.y = people.condensed;
    scene.x_title = x_title;
    scene.y_title = "rated dissimilarity";
    scene.corner = corner;
    scene.selected = scatter_selection(app, vibrations);
    scene.readout = [&](std::size_t k) {
        const auto [i, j] = pair_at(vibrations.size(), k);
        return std::vector<std::string>{
            vibrations[i].name + " \u2013 " + vibrations[j].name,
            "rated " + significant(people.condensed[k]) + ", rank " + significant(rank[k])};
    };
    scene.stale = shown_comparison(app).is_stale;
    const ScatterAction action = draw_scatter("pairs", app.theme, left, scene);
    note_rect(app.rects, "view:Pairs", left.min, left.max);
    for (std::size_t k = 0; k < rank.size() && !app.rects.file.empty() && rank.size() < 200; ++k) {
        const ImVec2 at = scatter_point(app.theme, left, scene, k);
        note_rect(app.rects, "pair point:" + std::to_string(k), at, at);
    }
    choose_clicked(app, vibrations, action.clicked);
    draw_list(app, comparison, row, {{left.max.x + app.theme.gap_px, area.min.y}, area.max});
}

// People rate intended patterns: beside their twins each of the two sides can be held against that.
void draw_sides(App& app) {
    const bool has_twins = std::ranges::any_of(app.document.set.vibrations, measures_another);
    if (shown_side(app) != Side::both || !has_twins) return;
    coloured_text(app.theme.dim_text,
                  "Patterns and their measured twins are shown together. Compare either side with "
                  "the ratings of the patterns:");
    if (ImGui::Button("Intended only")) show_side(app, Side::intended);
    note_item(app.rects, "button:intended only");
    flow_on(button_width("Measured only"), app.theme.gap_px);
    if (ImGui::Button("Measured only")) show_side(app, Side::measured);
    note_item(app.rects, "button:measured only");
}

void draw_no_ratings(App& app, const Comparison& comparison) {
    if (!comparison.fault.empty()) {
        coloured_text(app.theme.warning, "The ratings do not fit the set: " + comparison.fault);
        note_item(app.rects, "compare:fault", comparison.fault);
        return draw_sides(app);
    }
    ImGui::TextWrapped(
        "What did people say of these patterns? With their ratings this table tells which metric "
        "agrees with them best. Until then: how much each agrees with PM.");
    if (ImGui::Button("Load ratings...")) load_ratings_dialog(app);
    note_item(app.rects, "button:load ratings");
}

void draw_progress(App& app) {
    if (!app.comparison_job || !app.comparison_job->busy()) return;
    const float share = app.comparison_job->progress();
    char text[32];
    std::snprintf(text, sizeof text, "comparing, %d %%", static_cast<int>(100.0F * share));
    dim_text(app, text);
    ImGui::SameLine();
    if (link(app, "cancel comparison", "Cancel")) cancel_comparison(app);
    note_item(app.rects, "link:cancel comparison");
}

}  // namespace

bool draw_comparison_state(App& app) {
    const ShownComparison shown = shown_comparison(app);
    const bool few = app.document.set.vibrations.size() < 2;
    if (!few && comparison_waits(app) && !shown.is_computing && shown.is_stale) {
        ImGui::TextWrapped("Thirteen metrics of every pair and their maps: this may take a while.");
        if (ImGui::Button("Compare metrics")) ask_for_comparison(app);
        note_item(app.rects, "button:compare metrics");
    }
    draw_progress(app);
    if (shown.comparison && !few) return true;
    const Rect area = rest_of_pane();
    if (area.empty()) return false;
    draw_empty(*ImGui::GetWindowDrawList(), app.theme, area,
               few                  ? "No pairs to compare"
               : shown.is_computing ? "Comparing"
                                    : "Nothing compared yet",
               few                  ? "It takes two patterns to be alike or far apart."
               : shown.is_computing ? "Thirteen metrics of every pair, and a map of each."
                                    : "The metrics are compared once the space above is exact.");
    return false;
}

void draw_compare_panel(App& app) {
    draw_views(app);
    ImGui::Dummy({1.0F, 1.0F});
    if (app.compare.view == CompareView::findings) return draw_findings(app, rest_of_pane());
    if (!draw_comparison_state(app)) return;
    // Kept while it is drawn.
    const std::shared_ptr<const Comparison> comparison = app.comparison;
    if (comparison->people && !app.document.set.ratings.empty()) {
        draw_people(app, *comparison);
        if (!comparison->people->said.unrated.empty()) draw_sides(app);
    }
    if (!comparison->people) draw_no_ratings(app, *comparison);
    if (app.compare.view == CompareView::table) return draw_table(app, *comparison);
    draw_pairs(app, *comparison);
}

}  // namespace tact
