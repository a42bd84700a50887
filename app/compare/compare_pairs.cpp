// Rating against prediction, pair by pair, and the pairs with the largest difference.

#include <algorithm>
#include <cmath>

#include "app/compare/compare.h"
#include "app/document/editing.h"
#include "app/ui/widgets.h"
#include "model/text/numbers.h"
#include "model/textbook/textbook.h"
#include "viz/charts/scatter_view.h"
#include "viz/drawing/marks.h"
#include "viz/drawing/plot.h"

namespace tact {

namespace {

void draw_disagreement(Ui& ui, Workspace& work, Layout& layout, const Comparison& comparison,
                       const Disagreement& apart) {
    const auto& vibrations = comparison.request.map->request.set->vibrations;
    const auto [i, j] = pair_at(vibrations.size(), apart.pair);
    const std::string names = vibrations[i].name + " \u2013 " + vibrations[j].name;
    const bool closer = apart.ratings_rank < apart.metric_rank;
    const std::string by = words_of(mark_of(comparison));
    const std::string felt = by.empty() ? "felt " : by + " ratings say ";
    const ImFont* regular = ui.theme.fonts.regular;
    const float room = ImGui::GetContentRegionAvail().x;
    const auto* a = std::get_if<Pattern>(&vibrations[i].source);
    const auto* b = std::get_if<Pattern>(&vibrations[j].source);
    const std::string noticed = a != nullptr && b != nullptr ? noticed_text(*a, *b) : std::string();
    if (option(ui,
               {.id = "disagreement:" + vibrations[i].name + "|" + vibrations[j].name,
                .label = shortened(regular, names, room),
                .tip = names + ": why does the model tell them as it does?" +
                       (noticed.empty() ? "" : "\n" + noticed)},
               false)) {
        choose_pair(work, i, j);
        layout.bench = BenchTab::why;
    }
    ImGui::PushFont(ui.theme.fonts.small);
    const std::string ranks = felt + (closer ? "closer" : "farther") + ": rank " +
                              significant(apart.ratings_rank) + ", predicted " +
                              significant(apart.metric_rank);
    dim_text(ui, shortened(ui.theme.fonts.small, ranks, room));
    ImGui::PopFont();
}

// Heading and whole rows, as many as fit: a name, and its ranks in small type.
float whole_rows_px(const Ui& ui, std::size_t rows, float room_px) {
    const float spacing = ImGui::GetStyle().ItemSpacing.y;
    const float heading_px = ui.theme.fonts.semibold->FontSize + spacing;
    const float row_px =
        ui.theme.fonts.regular->FontSize + ui.theme.fonts.small->FontSize + 2.0F * spacing;
    const float fitting = std::floor(std::max(0.0F, room_px - heading_px) / row_px);
    return heading_px + row_px * std::clamp(fitting, 1.0F, static_cast<float>(rows));
}

void draw_list(Ui& ui, Workspace& work, Layout& layout, const Comparison& comparison,
               const ComparedMetric& row, const Rect& area) {
    ImGui::SetCursorScreenPos(area.min);
    const float height_px = whole_rows_px(ui, row.farthest.size(), area.height());
    ImGui::BeginChild("disagreements", {area.width(), std::min(height_px, area.height())});
    ImGui::PushFont(ui.theme.fonts.semibold);
    ImGui::TextUnformatted("Largest disagreements");
    ImGui::PopFont();
    for (const Disagreement& apart : row.farthest)
        draw_disagreement(ui, work, layout, comparison, apart);
    ImGui::EndChild();
}

}  // namespace

void draw_pairs_scatter(Ui& ui, Workspace& work, const ShownMap& shown_map, Comparing& comparing,
                        const Comparison& comparison, const Rect& area) {
    const ComparedMetric& row = metric_of_key(comparison, comparing.panel.metric);
    const Dissimilarity& people = comparison.people->said.rated.people.dissimilarity;
    const std::vector<double>& rank = row.ranks;
    const NumberMark mark = mark_of(comparison);
    std::string corner = of_people("rho ", mark) + with_decimals(row.evaluation->rho, 2);
    const double ceiling = comparison.people->said.ceilings.of_mean;
    if (!std::isnan(ceiling)) corner += ", at most " + with_decimals(ceiling, 2);
    const std::string y_title = of_people("rated dissimilarity", mark);
    const std::string rated = of_people("rated ", mark);
    const std::string x_title = "rank by " + row.name;
    const auto& vibrations = comparison.request.map->request.set->vibrations;
    ScatterScene scene;
    scene.x = rank;
    scene.y = people.condensed;
    scene.x_title = x_title;
    scene.y_title = y_title;
    scene.corner = corner;
    scene.selected = scatter_selection(work, shown_map, vibrations);
    scene.readout = [&](std::size_t k) {
        const auto [i, j] = pair_at(vibrations.size(), k);
        return std::vector<std::string>{
            vibrations[i].name + " \u2013 " + vibrations[j].name,
            rated + significant(people.condensed[k]) + ", rank " + significant(rank[k])};
    };
    const ShownComparison shown = shown_comparison(work, shown_map, comparing);
    scene.stale = looks_stale(ui, "pairs", shown.comparison, shown.is_stale);
    const ScatterAction action = draw_scatter("pairs", ui.theme, area, scene);
    note_rect(ui.rects, "view:Pairs", area.min, area.max, y_title + ", " + corner);
    for (std::size_t k = 0; k < rank.size() && !ui.rects.file.empty() && rank.size() < 200; ++k) {
        if (std::isnan(people.condensed[k])) continue;  // unrated pairs have no point
        const ImVec2 at = scatter_point(ui.theme, area, scene, k);
        note_rect(ui.rects, "pair point:" + std::to_string(k), at, at);
    }
    choose_clicked(work, vibrations, action.clicked);
}

void draw_compared_pairs(Ui& ui, Workspace& work, Layout& layout, const ShownMap& shown_map,
                         TableState& table, Comparing& comparing, const Comparison& comparison) {
    if (!comparison.people) {
        const Rect area = rest_of_pane();
        if (area.empty()) return;
        if (draw_empty_with(ui, area, "No ratings to compare with",
                            "Load what people said: each pair is then a point, prediction against "
                            "rating.",
                            {.id = "button:load ratings", .label = "Load ratings..."})) {
            load_ratings_dialog(ui, work, table);
        }
        return;
    }
    draw_metric_choice(ui, work, comparing, false);
    const Rect area = rest_of_pane();
    if (area.width() < 40.0F || area.height() < 40.0F) return;
    const ComparedMetric& row = metric_of_key(comparison, comparing.panel.metric);
    const float s = ui.theme.scale;
    // The list scrolls before the picture gets too narrow.
    const float list_px = whole_rows_px(ui, row.farthest.size(), 0.45F * area.height());
    const float least = std::min(0.42F * area.width(), 220.0F * s);
    const WordsAndPicture parts =
        words_and_picture(area, {least, std::max(least, 320.0F * s), list_px},
                          {180.0F * s, 120.0F * s}, ui.theme.gap_px);
    const Rect& picture = parts.picture.empty() ? area : parts.picture;
    draw_pairs_scatter(ui, work, shown_map, comparing, comparison, picture);
    if (!parts.picture.empty()) draw_list(ui, work, layout, comparison, row, parts.words);
}

}  // namespace tact
