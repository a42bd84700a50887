#include "app/patterns/neighbour_card.h"

#include <algorithm>
#include <cstdio>
#include <string>

#include "app/document/editing.h"
#include "app/map/map_follow.h"
#include "app/map/pair.h"
#include "app/ui/widgets.h"
#include "model/subset/confusable.h"
#include "viz/drawing/marks.h"
#include "viz/drawing/plot.h"

namespace tact {

namespace {

double largest_of(const LiveMap& map) { return map.sorted_pm.empty() ? 0.0 : map.sorted_pm.back(); }

std::string pm_words(const Workspace& work, const ShownMap& shown_map, const Neighbour& pair) {
    const LiveMap& map = *shown_map.transition.shown;
    std::string words = "PM " + significant(map.prediction.pm(pair.own, pair.closest)) + " of " +
                        significant(largest_of(map));
    const MapState state = map_state(work, shown_map);
    if (state == MapState::preview) words += ", preview";
    if (state == MapState::stale) words += ", before the edit";
    return words;
}

std::string verdict_help() {
    char text[320];
    std::snprintf(text, sizeof text,
                  "Same: no number differs by a felt step (Model, What people feel). Hard to tell: "
                  "PM of at most %.0f %% of the set's largest. Clear: farther. A guess: PM counts "
                  "ranks in this set, and nobody has measured where pairs are told apart.",
                  100.0 * kHardShare);
    return text;
}

ImU32 colour_of(const Ui& ui, PairVerdict verdict) {
    if (verdict == PairVerdict::same) return ui.theme.error;
    return verdict == PairVerdict::hard ? ui.theme.warning : ui.theme.dim_text;
}

void draw_words(Ui& ui, Workspace& work, const ShownMap& shown_map, const Neighbour& pair) {
    const LiveMap& map = *shown_map.transition.shown;
    const PairVerdict verdict =
        pair_verdict(*map.request.set, map.prediction.pm, pair.own, pair.closest, largest_of(map));
    const std::string& name = map.request.set->vibrations[pair.closest].name;
    const std::string pm = pm_words(work, shown_map, pair);
    const float room = ImGui::GetContentRegionAvail().x;
    dim_text(ui, "Closest");
    ImGui::SameLine(0.0F, ui.theme.gap_px);
    const std::string shown = shortened(ui.theme.fonts.regular, name,
                                        room - ImGui::GetItemRectSize().x - ui.theme.gap_px);
    if (link(ui, "closest name", shown)) select_only(work, pair.place);
    note_item(ui.rects, "neighbour:name", name);
    if (ImGui::IsItemHovered()) work.selection.hovered_pair = {work.selection.current, pair.place};
    ImGui::PushFont(ui.theme.fonts.small);
    coloured_text(colour_of(ui, verdict), std::string(words_of(verdict)) + "   " + pm);
    note_item(ui.rects, "neighbour:verdict", words_of(verdict));
    ImGui::PopFont();
    draw_tooltip(ui, verdict_help().c_str());
}

}  // namespace

std::optional<Neighbour> neighbour_of(const Workspace& work, const ShownMap& shown_map) {
    const auto pair = closest_pair(work, shown_map);
    if (!pair || !shown_map.transition.shown) return std::nullopt;
    const auto rows = rows_in_map(work, shown_map, *pair);
    if (!rows) return std::nullopt;
    return Neighbour{rows->first, rows->second, pair->partner};
}

float neighbour_card_px(const Ui& ui) {
    const float small =
        ui.theme.fonts.small != nullptr ? ui.theme.fonts.small->FontSize : ImGui::GetFontSize();
    return 2.0F * ImGui::GetTextLineHeightWithSpacing() + small + 2.0F * ui.theme.gap_px;
}

std::optional<NeighbourAction> draw_neighbour_card(Ui& ui, Workspace& work,
                                                   const ShownMap& shown_map,
                                                   const Neighbour& pair) {
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const float right = corner.x + ImGui::GetContentRegionAvail().x;
    ImGui::GetWindowDrawList()->AddLine(corner, {right, corner.y}, ui.theme.line,
                                        ui.theme.hairline_px);
    ImGui::SetCursorScreenPos({corner.x, corner.y + 0.5F * ui.theme.gap_px});
    draw_words(ui, work, shown_map, pair);
    std::optional<NeighbourAction> done;
    const auto deed = [&](const char* id, const char* words, NeighbourDeed what, const char* help,
                          bool first) {
        if (!first) flow_on(ImGui::CalcTextSize(words).x, 1.5F * ui.theme.gap_px);
        if (link(ui, id, words)) done = NeighbourAction{what, pair.place};
        note_item(ui.rects, std::string("neighbour:") + id);
        draw_tooltip(ui, help);
    };
    deed("play both", "Play both", NeighbourDeed::play_both, "This one, then the closest one.",
         true);
    deed("why closest", "Why", NeighbourDeed::why, "In what the two differ, to the model.", false);
    deed("separate closest", "Separate", NeighbourDeed::separate,
         "The smallest felt change of one number that would part the two.", false);
    return done;
}

}  // namespace tact
