#include "app/candidates/candidates.h"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <optional>
#include <string>

#include "app/candidates/parts.h"
#include "app/document/workspace.h"
#include "app/patterns/patterns.h"
#include "app/ui/widgets.h"
#include "model/text/numbers.h"
#include "viz/drawing/marks.h"
#include "viz/drawing/plot.h"

namespace tact {

// How wide the columns of the table are.

namespace {

struct ColumnWidth {
    CandidateColumn column;
    float least_px;
    float most_px;
};

// In the order of the table; the width at a scale of 1.
constexpr std::array kColumnWidths{ColumnWidth{CandidateColumn::picture, 56.0F, 260.0F},
                                   ColumnWidth{CandidateColumn::name, 100.0F, 240.0F},
                                   ColumnWidth{CandidateColumn::amplitude, 38.0F, 72.0F},
                                   ColumnWidth{CandidateColumn::carrier, 42.0F, 90.0F},
                                   ColumnWidth{CandidateColumn::modulation, 48.0F, 84.0F},
                                   ColumnWidth{CandidateColumn::rhythm, 70.0F, 140.0F},
                                   ColumnWidth{CandidateColumn::duration, 40.0F, 72.0F},
                                   ColumnWidth{CandidateColumn::nearest, 54.0F, 110.0F},
                                   ColumnWidth{CandidateColumn::picked, 34.0F, 64.0F}};

constexpr std::array kFirstToGo{CandidateColumn::duration, CandidateColumn::picture,
                                CandidateColumn::rhythm, CandidateColumn::modulation};

// All a little narrower, before a column goes.
constexpr float kLeastSqueeze = 0.96F;

}  // namespace

std::vector<ColumnSpan> column_places(float width_px, float scale, float nearest_px) {
    std::vector<ColumnWidth> shown(kColumnWidths.begin(), kColumnWidths.end());
    for (ColumnWidth& column : shown) {
        if (column.column != CandidateColumn::nearest) continue;
        column.least_px = std::max(column.least_px, nearest_px);
        column.most_px = std::max(column.most_px, nearest_px);
    }
    const auto sum = [&shown](float ColumnWidth::*width) {
        float total = 0.0F;
        for (const ColumnWidth& column : shown) total += column.*width;
        return total;
    };
    for (const CandidateColumn gone : kFirstToGo) {
        if (kLeastSqueeze * scale * sum(&ColumnWidth::least_px) <= width_px) break;
        std::erase_if(shown, [gone](const ColumnWidth& c) { return c.column == gone; });
    }
    const float least = sum(&ColumnWidth::least_px);
    const float spread = sum(&ColumnWidth::most_px) - least;
    const float share = std::clamp((width_px / scale - least) / std::max(spread, 1.0F), 0.0F, 1.0F);
    const float most = scale * sum(&ColumnWidth::most_px);
    // What is left has no room either: all of it a little narrower, and nothing beyond the pane.
    const float squeeze = std::min(1.0F, width_px / std::max(1.0F, scale * least));
    std::vector<ColumnSpan> places;
    float at = 0.0F;
    for (const ColumnWidth& column : shown) {
        const bool is_picture = column.column == CandidateColumn::picture;
        const float left_over = is_picture ? std::max(0.0F, width_px - most) : 0.0F;
        const float width =
            left_over +
            squeeze * scale * (column.least_px + share * (column.most_px - column.least_px));
        places.push_back({column.column, at, at + width});
        at += width;
    }
    return places;
}

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

namespace {

// A tick; hollow where it is of a preview.
void draw_picked_mark(const Theme& theme, ImVec2 centre, bool preview) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float r = 5.0F * theme.scale;
    if (preview) return list.AddCircle(centre, r, theme.text, 0, 1.5F * theme.hairline_px);
    list.AddCircleFilled(centre, r, theme.text);
}

std::string cell_words(const CandidateRow& row, CandidateColumn column) {
    const std::optional<double> number = number_in(row, column);
    if (!number) return {};
    if (column == CandidateColumn::nearest) return grouped(*number);
    std::string words = significant_digits(*number, 3);
    if (column == CandidateColumn::carrier && !row.mean_hz) {
        for (const double hz : row.further_hz) words += " + " + significant_digits(hz, 3);
    }
    return words;
}

void draw_rhythm_cell(const Theme& theme, const CandidateRow& row, const Rect& cell) {
    if (!row.rhythm) return;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImFont* font = theme.fonts.small;
    const float y = cell.centre().y - text_size(font, "x").y / 2.0F;
    if (row.rhythm->empty()) {
        const std::string words = row.ticks > 0 ? counted(row.ticks, "tick", "ticks") : "steady";
        return draw_text(list, font, {cell.min.x, y}, theme.dim_text, words);
    }
    const float each =
        std::min(8.0F * theme.scale, cell.width() / static_cast<float>(row.rhythm->size()));
    if (each < 2.0F * theme.scale) {
        const auto notes = onsets(*row.rhythm).size();
        return draw_text(list, font, {cell.min.x, y}, theme.dim_text,
                         counted(notes, "note", "notes"));
    }
    const float half = 5.0F * theme.scale;
    draw_rhythm_cells(
        theme,
        {{cell.min.x, cell.centre().y - half},
         {cell.min.x + each * static_cast<float>(row.rhythm->size()), cell.centre().y + half}},
        *row.rhythm);
}

void draw_name_cell(Ui& ui, const Vibration& vibration, const PatternLook& look, const Rect& cell) {
    const Theme& theme = ui.theme;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float s = theme.scale;
    draw_pattern_mark(list, theme, {cell.min.x + 5.0F * s, cell.centre().y}, 4.5F * s, look,
                      theme.pane);
    draw_state_signs(ui, vibration, {cell.max.x, cell.centre().y});
    const float begin = cell.min.x + 15.0F * s;
    const float room = cell.max.x - begin - state_signs_px(theme, vibration);
    const std::string name = shortened(theme.fonts.regular, vibration.name, std::max(0.0F, room));
    const float y = cell.centre().y - text_size(theme.fonts.regular, name).y / 2.0F;
    draw_text(list, theme.fonts.regular, {begin, y},
              vibration.dropped ? theme.dim_text : theme.text, name);
}

}  // namespace

void draw_cell(Ui& ui, Workspace& work, const CandidateRow& row, CandidateColumn column,
               const Rect& cell) {
    const Theme& theme = ui.theme;
    const Vibration& vibration = work.document.set.vibrations[row.place];
    switch (column) {
        case CandidateColumn::picture:
            return draw_thumbnail(ui, work, cell, vibration, look_of(ui, work, row.place).colour,
                                  shown_reach_g(work), work.cache.axis_s);
        case CandidateColumn::name:
            return draw_name_cell(ui, vibration, look_of(ui, work, row.place), cell);
        case CandidateColumn::rhythm:
            return draw_rhythm_cell(theme, row, cell);
        case CandidateColumn::picked:
            if (!row.picked) return;
            return draw_picked_mark(theme, cell.centre(), work.selection.is_pick_preview);
        default:
            break;
    }
    std::string words = cell_words(row, column);
    const auto is_wide = [&] { return text_size(theme.fonts.regular, words).x > cell.width(); };
    // Half a number would be a wrong one: without room the further carriers are a plus, and any
    // other number is smaller.
    if (column == CandidateColumn::carrier && !row.further_hz.empty() && is_wide())
        words = words.substr(0, words.find(' ')) + "+";
    const ImFont* font = is_wide() ? theme.fonts.small : theme.fonts.regular;
    const ImVec2 size = text_size(font, words);
    draw_text(*ImGui::GetWindowDrawList(), font,
              {cell.max.x - size.x, cell.centre().y - size.y / 2.0F}, theme.text, words);
}

}  // namespace tact
