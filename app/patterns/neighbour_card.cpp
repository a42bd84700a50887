#include "app/patterns/patterns.h"

#include <algorithm>
#include <string>

#include "app/document/editing.h"
#include "app/map/map.h"
#include "app/ui/widgets.h"
#include "model/subset/confusable.h"
#include "model/text/numbers.h"
#include "viz/drawing/marks.h"
#include "viz/drawing/plot.h"

namespace tact {

namespace {

std::string pm_words(const Workspace& work, const ShownMap& shown_map, const Neighbour& pair) {
    const LiveMap& map = *shown_map.transition.shown;
    std::string words = "PM " + grouped(map.prediction.pm(pair.own, pair.closest)) + " of " +
                        grouped(largest_pm(map));
    const MapState state = map_state(work, shown_map);
    if (state == MapState::preview) words += ", preview";
    if (state == MapState::stale) words += ", before the edit";
    return words;
}

std::string verdict_help(const FeltSteps& steps, PairVerdict verdict) {
    const auto step = [&](PatternParameter parameter) {
        return percent(step_of(steps, parameter) - 1.0);
    };
    return std::string(sentence_of(verdict)) +
           " A felt step is what people are taken to feel: of an amplitude " +
           step(PatternParameter::amplitude) + ", of a carrier " + step(PatternParameter::carrier) +
           " (Model, What people feel).";
}

ImU32 colour_of(const Ui& ui, PairVerdict verdict) {
    if (verdict == PairVerdict::same) return ui.theme.error;
    return verdict == PairVerdict::close ? ui.theme.warning : ui.theme.dim_text;
}

constexpr const char* kPlay = "Play both";
constexpr const char* kWhy = "Why";
constexpr const char* kSeparate = "Separate";

float links_px(const Ui& ui) {
    const ImFont* font = ui.theme.fonts.regular;
    return text_size(font, kPlay).x + text_size(font, kWhy).x + text_size(font, kSeparate).x +
           2.0F * 1.5F * ui.theme.gap_px;
}

// Beside the links if there is room, otherwise on a separate line.
bool pm_goes_beside(const Ui& ui, const std::string& pm, float room_px) {
    return links_px(ui) + 2.0F * ui.theme.gap_px + text_size(ui.theme.fonts.small, pm).x <= room_px;
}

// Everything in one line of a wide pane.
bool fits_in_line(const Ui& ui, const std::string& pm, float room_px) {
    constexpr float kNamePx = 120.0F;  // with its verdict
    return kNamePx * ui.theme.scale + 4.0F * ui.theme.gap_px +
               text_size(ui.theme.fonts.small, pm).x + links_px(ui) <=
           room_px;
}

// Small type on the current line, at its right end or at the cursor.
void draw_small(const Ui& ui, ImU32 colour, const std::string& text, float right) {
    const ImFont* font = ui.theme.fonts.small;
    const ImVec2 size = text_size(font, text);
    ImVec2 corner = ImGui::GetCursorScreenPos();
    if (right > 0.0F) corner.x = right - size.x;
    const float lower = 0.8F * (ImGui::GetTextLineHeight() - size.y);
    draw_text(*ImGui::GetWindowDrawList(), font, {corner.x, corner.y + lower}, colour, text);
    ImGui::SetCursorScreenPos(corner);
    ImGui::Dummy({size.x, ImGui::GetTextLineHeight()});
}

// Its name, and at the right end the verdict.
void draw_name(Ui& ui, Workspace& work, const ShownMap& shown_map, const Neighbour& pair,
               float right) {
    const LiveMap& map = *shown_map.transition.shown;
    const PairVerdict verdict = pair_verdict(*map.request.set, pair.own, pair.closest);
    const std::string& name = map.request.set->vibrations[pair.closest].name;
    dim_text(ui, "Closest");
    ImGui::SameLine(0.0F, ui.theme.gap_px);
    // A long verdict is cut short in favour of the name.
    const ImFont* small = ui.theme.fonts.small;
    const float free = right - ImGui::GetCursorScreenPos().x - ui.theme.gap_px;
    const float least = 48.0F * ui.theme.scale;
    const std::string words = shortened(small, words_of(verdict), std::max(0.0F, free - least));
    const float room = free - text_size(small, words).x;
    if (name_link(ui, {.id = "neighbour:name",
                       .label = shortened(ui.theme.fonts.regular, name, std::max(1.0F, room)),
                       .value = name})) {
        select_only(work, pair.place);
    }
    if (ImGui::IsItemHovered()) work.selection.hovered_pair = {work.selection.current, pair.place};
    ImGui::SameLine(0.0F, ui.theme.gap_px);
    draw_small(ui, colour_of(ui, verdict), words, right);
    say_of_last_item(ui, {.id = "neighbour:verdict",
                          .text = words_of(verdict),
                          .tip = verdict_help(work.document.set.felt_steps, verdict)});
}

}  // namespace

std::optional<Neighbour> neighbour_of(const Workspace& work, const ShownMap& shown_map) {
    const auto pair = closest_pair(work, shown_map);
    if (!pair || !shown_map.transition.shown) return std::nullopt;
    const auto rows = rows_in_map(work, shown_map, *pair);
    if (!rows) return std::nullopt;
    const auto& nearest = shown_map.transition.shown->nearest;
    if (!nearest[rows->first].exists_for(rows->first)) return std::nullopt;  // nobody feels it
    return Neighbour{rows->first, rows->second, pair->partner};
}

float neighbour_card_px(const Ui& ui, const Workspace& work, const ShownMap& shown_map,
                        const Neighbour& pair) {
    const float room = ImGui::GetContentRegionAvail().x;
    const std::string pm = pm_words(work, shown_map, pair);
    if (fits_in_line(ui, pm, room)) return ImGui::GetTextLineHeightWithSpacing();
    const bool beside = pm_goes_beside(ui, pm, room);
    return (beside ? 2.0F : 3.0F) * ImGui::GetTextLineHeightWithSpacing() + ui.theme.gap_px;
}

std::optional<NeighbourAction> draw_neighbour_card(Ui& ui, Workspace& work,
                                                   const ShownMap& shown_map,
                                                   const Neighbour& pair) {
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const float room = ImGui::GetContentRegionAvail().x;
    const float right = corner.x + room;
    const std::string pm = pm_words(work, shown_map, pair);
    const bool in_line = fits_in_line(ui, pm, room);
    const bool beside = !in_line && pm_goes_beside(ui, pm, room);
    if (in_line) {
        const float pm_px = text_size(ui.theme.fonts.small, pm).x;
        const float links = right - links_px(ui);
        draw_name(ui, work, shown_map, pair, links - pm_px - 4.0F * ui.theme.gap_px);
        ImGui::SameLine(0.0F, ui.theme.gap_px);
        draw_small(ui, ui.theme.dim_text, pm, links - 2.0F * ui.theme.gap_px);
        ImGui::SameLine();
        ImGui::SetCursorScreenPos({links, corner.y});
    } else {
        ImGui::GetWindowDrawList()->AddLine(corner, {right, corner.y}, ui.theme.line,
                                            ui.theme.hairline_px);
        ImGui::SetCursorScreenPos({corner.x, corner.y + 0.5F * ui.theme.gap_px});
        draw_name(ui, work, shown_map, pair, right);
        if (!beside) {
            draw_small(ui, ui.theme.dim_text, shortened(ui.theme.fonts.small, pm, room), 0.0F);
        }
    }
    std::optional<NeighbourAction> done;
    const auto action = [&](const char* id, const char* words, NeighbourChoice what,
                            const char* help, bool first) {
        if (!first) flow_on(ImGui::CalcTextSize(words).x, 1.5F * ui.theme.gap_px);
        if (link(ui, {.id = std::string("neighbour:") + id, .label = words, .tip = help}))
            done = NeighbourAction{what, pair.place};
    };
    action("play both", kPlay, NeighbourChoice::play_both, "This one, then the closest one.", true);
    action("why closest", kWhy, NeighbourChoice::why, "In what the two differ, to the model.",
           false);
    action("separate closest", kSeparate, NeighbourChoice::separate,
           "The smallest felt change of one number that would part the two.", false);
    if (beside) {
        ImGui::SameLine(0.0F, ui.theme.gap_px);
        draw_small(ui, ui.theme.dim_text, pm, right);
    }
    return done;
}

}  // namespace tact
