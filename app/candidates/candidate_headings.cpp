#include <imgui.h>

#include <algorithm>
#include <string>

#include "app/candidates/candidate_parts.h"
#include "app/candidates/candidate_rows.h"
#include "app/ui/widgets.h"
#include "viz/drawing/marks.h"
#include "viz/drawing/plot.h"

namespace tact {

namespace {

const char* heading(CandidateColumn column) {
    switch (column) {
        case CandidateColumn::picture:
            return "set";
        case CandidateColumn::name:
            return "name";
        case CandidateColumn::amplitude:
            return "g";
        case CandidateColumn::carrier:
            return "Hz";
        case CandidateColumn::modulation:
            return "mod Hz";
        case CandidateColumn::rhythm:
            return "rhythm";
        case CandidateColumn::duration:
            return "s";
        case CandidateColumn::nearest:
            return "nearest";
        case CandidateColumn::picked:
            return "picked";
    }
    return "";
}

// What has no room is said shorter, with its unit.
std::string heading_words(const ImFont* font, CandidateColumn column, float room_px) {
    const bool is_nearest = column == CandidateColumn::nearest;
    const std::string whole = is_nearest ? "nearest PM" : heading(column);
    const std::string brief = is_nearest                          ? "near PM"
                              : column == CandidateColumn::picked ? "pick"
                                                                  : whole;
    return shortened(font, text_size(font, whole).x <= room_px ? whole : brief, room_px);
}

const char* heading_help(CandidateColumn column) {
    switch (column) {
        case CandidateColumn::picture:
            return "In the order of the set.";
        case CandidateColumn::amplitude:
            return "Amplitude; where curves or transients are drawn, their peak.";
        case CandidateColumn::carrier:
            return "Carriers. 70+: others are mixed with it, which a row's tooltip names. Where "
                   "curves or transients are drawn, the mean by strength.";
        case CandidateColumn::nearest:
            return "PM to the closest other pattern of the set, which a row's tooltip names.";
        case CandidateColumn::picked:
            return "In the most distinct subset: see Subset. A hollow mark is of a preview.";
        default:
            return "Sort by it; again: the other way round.";
    }
}

bool is_right_aligned(CandidateColumn column) {
    return column == CandidateColumn::amplitude || column == CandidateColumn::carrier ||
           column == CandidateColumn::modulation || column == CandidateColumn::duration ||
           column == CandidateColumn::nearest;
}

// The arrow of the column that is sorted by.
void draw_sort_arrow(const Ui& ui, ImVec2 centre, bool descending) {
    const float r = 3.0F * ui.theme.scale;
    const float d = descending ? r : -r;
    ImGui::GetWindowDrawList()->AddTriangleFilled({centre.x - r, centre.y - 0.6F * d},
                                                  {centre.x + r, centre.y - 0.6F * d},
                                                  {centre.x, centre.y + 0.8F * d}, ui.theme.text);
}

void draw_heading(Ui& ui, CandidatesState& state, const ColumnSpan& place, const Rect& line) {
    const Theme& theme = ui.theme;
    const Rect cell{{line.min.x + place.begin_px, line.min.y},
                    {line.min.x + place.end_px, line.max.y}};
    ImGui::SetCursorScreenPos(cell.min);
    ImGui::PushID(static_cast<int>(place.column));
    if (ImGui::InvisibleButton("heading", cell.size())) sort_by(state, place.column);
    note_item(ui.rects, std::string("candidates:by ") + heading(place.column),
              state.by != place.column ? ""
              : state.descending       ? "down"
                                       : "up");
    const bool lit = ImGui::IsItemHovered();
    draw_tooltip(ui, heading_help(place.column));
    ImGui::PopID();
    const ImFont* font = theme.fonts.small;
    const std::string words = heading_words(font, place.column, cell.width() - 6.0F * theme.scale);
    const ImVec2 size = text_size(font, words);
    const float pad = 6.0F * theme.scale;
    const float y = cell.centre().y - size.y / 2.0F;
    const bool right = is_right_aligned(place.column);
    const float x = right ? cell.max.x - pad - size.x : cell.min.x + pad;
    const bool sorted = state.by == place.column;
    draw_text(*ImGui::GetWindowDrawList(), font, {x, y},
              sorted || lit ? theme.text : theme.dim_text, words);
    if (!sorted) return;
    const float beside = 7.0F * theme.scale;
    draw_sort_arrow(ui, {right ? x - beside : x + size.x + beside, cell.centre().y},
                    state.descending);
}

}  // namespace

void draw_headings(Ui& ui, CandidatesState& state, const std::vector<ColumnSpan>& places) {
    const Theme& theme = ui.theme;
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const float width = std::max(1.0F, ImGui::GetContentRegionAvail().x);
    const Rect line = rect_at(corner, {width, 20.0F * theme.scale});
    for (const ColumnSpan& place : places) draw_heading(ui, state, place, line);
    ImGui::GetWindowDrawList()->AddLine({line.min.x, line.max.y}, line.max, theme.line,
                                        theme.hairline_px);
    ImGui::SetCursorScreenPos({corner.x, line.max.y + theme.scale});
}

}  // namespace tact
