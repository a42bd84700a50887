// PM, NC or OC of every pair as a heat map, and the pair under the mouse in numbers.

#include <algorithm>
#include <array>
#include <numeric>

#include "app/document/editing.h"
#include "app/map/map.h"
#include "app/progress/progress.h"
#include "app/ui/widgets.h"
#include "model/text/numbers.h"
#include "viz/charts/matrix_view.h"
#include "viz/drawing/marks.h"

namespace tact {

namespace {

const Dissimilarity& shown_matrix(const ShownMap& shown_map) {
    const LiveMap& map = *shown_map.transition.shown;
    if (shown_map.quantity == MatrixQuantity::nc) return map.nc;
    if (shown_map.quantity == MatrixQuantity::oc) return map.oc;
    return map.prediction.pm;
}

double shown_largest(ShownMap& shown_map) {
    ShownLargest& kept = shown_map.largest;
    const auto& map = shown_map.transition.shown;
    if (kept.of == map && kept.quantity == shown_map.quantity) return kept.value;
    kept = {map, shown_map.quantity, 0.0};
    for (const double value : shown_matrix(shown_map).condensed) {
        if (value > kept.value) kept.value = value;
    }
    return kept.value;
}

const std::vector<std::size_t>& alike_rows(const ShownMap& shown_map) {
    const RowOrders& alike = shown_map.transition.shown->alike;
    if (shown_map.quantity == MatrixQuantity::nc) return alike.nc;
    if (shown_map.quantity == MatrixQuantity::oc) return alike.oc;
    return alike.pm;
}

// The rows as they are to be drawn: by the list, or alike ones beside each other.
const ShownOrder& shown_order(ShownMap& shown_map) {
    ShownOrder& kept = shown_map.order;
    const auto& map = shown_map.transition.shown;
    const bool is_known = kept.of == map && kept.quantity == shown_map.quantity &&
                          kept.is_clustered == shown_map.clustered_matrix;
    if (is_known && !(kept.is_held && !ImGui::IsAnyItemActive())) return kept;
    const std::size_t size = shown_matrix(shown_map).size;
    const bool is_clustered = shown_map.clustered_matrix && alike_rows(shown_map).size() == size;
    // While something is dragged, rows do not jump.
    const bool is_held =
        is_clustered && kept.is_clustered && ImGui::IsAnyItemActive() && kept.order.size() == size;
    std::vector<std::size_t> order(size);
    std::iota(order.begin(), order.end(), 0U);
    if (is_held) {
        order = std::move(kept.order);
    } else if (is_clustered) {
        order = alike_rows(shown_map);
    }
    kept = {map, shown_map.quantity, shown_map.clustered_matrix, std::move(order), {}, is_held};
    for (const std::size_t row : kept.order) {
        kept.labels.push_back(map->request.set->vibrations[row].name);
    }
    return kept;
}

// Where a row of the map is drawn.
std::size_t drawn_row(const ShownOrder& order, std::size_t row) {
    return static_cast<std::size_t>(std::ranges::find(order.order, row) - order.order.begin());
}

// All that are selected, as drawn.
std::vector<std::size_t> selected_rows(const Workspace& work, const ShownMap& shown_map,
                                       const ShownOrder& order) {
    const RowPlaces places = places_in_document(work, shown_map);
    std::vector<std::size_t> rows;
    for (std::size_t drawn = 0; drawn < places.size(); ++drawn) {
        const auto place = places[order.order[drawn]];
        const bool selected =
            place && (*place == work.selection.current || work.selection.others.contains(*place));
        if (selected) rows.push_back(drawn);
    }
    return rows;
}

constexpr const char* quantity_name(MatrixQuantity quantity) {
    if (quantity == MatrixQuantity::nc) return "NC";
    if (quantity == MatrixQuantity::oc) return "OC";
    return "PM";
}

void draw_choice(Ui& ui, ShownMap& shown_map) {
    constexpr std::array kQuantities{
        Choice{MatrixQuantity::pm, quantity_name(MatrixQuantity::pm),
               "Predicted dissimilarity: the weighted ranks of NC and OC. It depends on the set: "
               "a pattern more or less changes every number."},
        Choice{MatrixQuantity::nc, quantity_name(MatrixQuantity::nc),
               "Neural coding: difference of the predicted brain waveforms."},
        Choice{MatrixQuantity::oc, quantity_name(MatrixQuantity::oc),
               "Rhythm: dynamic time warping of the two envelopes."}};
    draw_segments(ui, kQuantities, shown_map.quantity);
}

// At the right end of the foot: the order of the rows. Returns what is left of the foot.
Rect draw_order_choice(Ui& ui, ShownMap& shown_map, Rect foot) {
    const char* words = shown_map.clustered_matrix ? "Rows as listed" : "Alike together";
    const ImVec2 size = text_size(ui.theme.fonts.small, words);
    if (foot.width() < 3.0F * size.x) return foot;
    ImGui::PushFont(ui.theme.fonts.small);
    ImGui::SetCursorScreenPos({foot.max.x - size.x, foot.min.y});
    bool& clustered = shown_map.clustered_matrix;
    const Item item{
        .id = "link:matrix order",
        .label = words,
        .tip = "The order of the rows: a tree of clusters (average linkage), or the list's.",
        .value = clustered ? "clustered" : "list"};
    if (link(ui, item)) clustered = !clustered;
    ImGui::PopFont();
    foot.max.x -= size.x + ui.theme.gap_px;
    return foot;
}

// The pair's numbers beneath the map: all three, so that PM explains itself.
void draw_pair(Ui& ui, const ShownMap& shown_map, const Rect& area, std::optional<Pair> pair) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const Theme& theme = ui.theme;
    if (!pair) {
        const char* hint = "Point at a cell for its numbers; a click selects.";
        draw_text(list, theme.fonts.small, area.min, theme.dim_text,
                  shortened(theme.fonts.small, hint, area.width()));
        return;
    }
    const auto [i, j] = *pair;
    const LiveMap& map = *shown_map.transition.shown;
    const Prediction& prediction = map.prediction;
    const std::size_t m = prediction.pm.condensed.size();
    const std::size_t k = pair_index(prediction.pm.size, std::min(i, j), std::max(i, j));
    const auto& all = map.request.set->vibrations;
    const std::string names = all[i].name + "   " + all[j].name;
    const std::string shown_names = shortened(theme.fonts.semibold, names, 0.5F * area.width());
    draw_text(list, theme.fonts.semibold, area.min, theme.text, shown_names);
    const ImVec2 taken = text_size(theme.fonts.semibold, shown_names);
    const std::string numbers = "PM " + grouped(prediction.pm.condensed[k], 4) + " of " +
                                grouped(static_cast<double>(m), 4) + "    NC " +
                                significant_digits(map.nc.condensed[k], 3) + ", rank " +
                                grouped(prediction.nc_rank[k], 4) + "    OC " +
                                significant_digits(map.oc.condensed[k], 4) + ", rank " +
                                grouped(prediction.oc_rank[k], 4);
    const float left = area.min.x + taken.x + 1.5F * theme.gap_px;
    const float lower = 0.8F * (taken.y - text_size(theme.fonts.small, numbers).y);
    draw_text(list, theme.fonts.small, {left, area.min.y + lower}, theme.dim_text,
              shortened(theme.fonts.small, numbers, std::max(0.0F, area.max.x - left)));
    note_rect(ui.rects, "pair", area.min, area.max, names + "\t" + numbers);
}

// The pair that the map joins by a line while one of its points is under the mouse: the cell of it.
std::optional<Pair> pair_in_map(const Workspace& work, const PatternSet& mapped) {
    const Vibration* current = current_vibration(work);
    const auto hovered = work.selection.hovered_last;
    const auto& all = work.document.set.vibrations;
    if (current == nullptr || !hovered || *hovered >= all.size()) return std::nullopt;
    const auto a = place_named(mapped, current->name);
    const auto b = place_named(mapped, all[*hovered].name);
    if (!a || !b || *a == *b) return std::nullopt;
    return Pair{*a, *b};
}

void note_selected(Ui& ui, const Rect& area, const std::vector<std::size_t>& rows,
                   const std::vector<std::string>& labels) {
    if (ui.rects.file.empty()) return;
    std::string names;
    for (const std::size_t row : rows) names += labels[row] + "|";
    note_rect(ui.rects, "matrix selected", area.min, area.max, names);
}

// Clicks choose a pair or a row; what is pointed at is told to the other panes.
void act_on(Workspace& work, const MatrixAction& action, const std::vector<std::string>& labels) {
    const auto place = [&](std::size_t row) { return place_named(work.document.set, labels[row]); };
    if (action.clicked) {
        const auto a = place(action.clicked->first);
        const auto b = place(action.clicked->second);
        if (a && b) choose_pair(work, *a, *b);
    }
    if (action.clicked_row) {
        if (const auto row = place(*action.clicked_row)) select_only(work, *row);
    }
    if (action.hovered) {
        work.selection.hovered = place(action.hovered->second);
        const auto first = place(action.hovered->first);
        if (first && work.selection.hovered) {
            work.selection.hovered_pair = {*first, *work.selection.hovered};
        }
    }
}

}  // namespace

void draw_matrix_panel(Ui& ui, Workspace& work, ShownMap& shown_map) {
    if (!ui.as_picture) draw_choice(ui, shown_map);
    const bool failed = draw_failure(ui, "matrix", shown_map.full_job.failure());
    Rect area = rest_of_pane();
    if (area.empty()) return;
    const bool few = work.document.set.vibrations.size() < 2;
    const bool has_pairs = !few && shown_map.transition.shown &&
                           !shows_another_set(work, shown_map) &&
                           !shown_map.transition.shown->prediction.pm.condensed.empty();
    if (!has_pairs || map_state(work, shown_map) == MapState::too_large) {
        if (failed) return;
        draw_empty(*ImGui::GetWindowDrawList(), ui.theme, area,
                   few ? "No pairs to compare" : "No matrix yet",
                   few ? "It takes two patterns to be alike or far apart."
                       : "It is computed together with the space above.");
        return;
    }
    const PatternSet& mapped = *shown_map.transition.shown->request.set;
    const ShownOrder& order = shown_order(shown_map);
    const std::vector<std::string>& labels = order.labels;
    // Low panes need it for the map; the pair under the mouse is told there, too.
    const float line = ImGui::GetTextLineHeightWithSpacing();
    const bool has_foot = !ui.as_picture && area.height() > 9.0F * line;
    const float foot = has_foot ? 1.1F * line : 0.0F;
    Rect foot_area = area;
    foot_area.min.y = area.max.y - foot;
    area.max.y = foot_area.min.y - ui.theme.gap_px * 0.5F;

    MatrixScene scene;
    scene.condensed = shown_matrix(shown_map).condensed;
    scene.order = order.order;
    scene.labels = labels;
    scene.quantity = quantity_name(shown_map.quantity);
    scene.largest = shown_largest(shown_map);
    scene.stale = looks_stale(ui, "matrix", shown_map.transition.shown,
                              map_state(work, shown_map) == MapState::stale);
    const std::vector<std::size_t> selected = selected_rows(work, shown_map, order);
    scene.selected = selected;
    scene.pointed = pair_in_map(work, mapped);
    if (scene.pointed) {
        scene.pointed =
            Pair{drawn_row(order, scene.pointed->first), drawn_row(order, scene.pointed->second)};
    }
    note_rect(
        ui.rects, "view:Matrix", area.min, area.max,
        scene.pointed ? labels[scene.pointed->first] + "|" + labels[scene.pointed->second] : "");
    note_selected(ui, area, selected, labels);
    const MatrixAction action = draw_matrix("matrix", ui.theme, area, scene);
    act_on(work, action, labels);
    if (!has_foot) return;
    const Rect rest = draw_order_choice(ui, shown_map, foot_area);
    std::optional<Pair> hovered = action.hovered;
    if (hovered) hovered = Pair{order.order[hovered->first], order.order[hovered->second]};
    draw_pair(ui, shown_map, rest, hovered);
}

}  // namespace tact
