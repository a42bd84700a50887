#include <imgui.h>

#include <algorithm>
#include <optional>
#include <string>

#include "app/candidates/candidate_parts.h"
#include "app/candidates/candidate_rows.h"
#include "app/document/pattern_looks.h"
#include "app/patterns/rhythm_list.h"
#include "app/ui/widgets.h"
#include "model/text/numbers.h"
#include "viz/drawing/marks.h"
#include "viz/drawing/plot.h"

namespace tact {

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
