#include "app/candidates/candidates_panel.h"

#include <imgui.h>
// After imgui.h.
#include <imgui_stdlib.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

#include "app/candidates/candidate_rows.h"
#include "app/document/editing.h"
#include "app/document/pattern_looks.h"
#include "app/document/pressing.h"
#include "app/patterns/rhythm_list.h"
#include "app/ui/widgets.h"
#include "model/design_space/candidates.h"
#include "model/text/numbers.h"
#include "viz/drawing/colour.h"
#include "viz/drawing/marks.h"
#include "viz/drawing/plot.h"

namespace tact {

namespace {

constexpr float kTableRowPx = 24.0F;

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

const char* heading_help(CandidateColumn column) {
    switch (column) {
        case CandidateColumn::picture:
            return "In the order of the set.";
        case CandidateColumn::carrier:
            return "The first carrier.";
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

void draw_table_tools(Ui& ui, Workspace& work, std::size_t listed) {
    Selection& selection = work.selection;
    ImGui::SetNextItemWidth(std::min(170.0F * ui.theme.scale, ImGui::GetContentRegionAvail().x));
    ImGui::InputTextWithHint("##filter", "60 Hz, x--x, a name", &selection.search);
    note_item(ui.rects, "candidates:filter", selection.search);
    const std::string count = std::to_string(selection.picked.size());
    const std::string only = selection.picked.empty() ? "only picked" : "only picked: " + count;
    flow_on(chip_width(ui, only.c_str()), ui.theme.gap_px);
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const float chip_px = text_size(ui.theme.fonts.small, only).y + 6.0F * ui.theme.scale;
    ImGui::SetCursorScreenPos({corner.x, corner.y + 0.5F * (ImGui::GetFrameHeight() - chip_px)});
    if (draw_chip(ui, "only picked", only.c_str(), selection.only_picked)) {
        selection.only_picked = !selection.only_picked;
    }
    note_item(ui.rects, "candidates:only picked", selection.only_picked ? "on" : "off");
    ImGui::SameLine(0.0F, 0.0F);
    ImGui::SetCursorScreenPos({ImGui::GetCursorScreenPos().x, corner.y});
    ImGui::Dummy({0.0F, ImGui::GetFrameHeight()});
    const Vibration* current = current_vibration(work);
    const auto deed = [&](const char* id, const char* words, auto act) {
        flow_on(button_width(words), ui.theme.gap_px);
        if (ImGui::Button(words)) ui.waiting.emplace_back([&ui, &work, act] { act(ui, work); });
        note_item(ui.rects, std::string("candidates:") + id);
    };
    if (current == nullptr) return;
    deed("lock", current->locked ? "Unlock" : "Lock", toggle_locked);
    draw_tooltip(ui, "All selected rows: picked in every subset, and not edited.");
    deed("drop", current->dropped ? "Take back" : "Drop", toggle_dropped);
    draw_tooltip(ui, "All selected rows: picked in no subset.");
    const std::string told = std::to_string(listed) + " of " +
                             std::to_string(work.document.set.vibrations.size()) + ", " +
                             std::to_string(selected_indices(work).size()) + " selected";
    flow_on(text_size(ui.theme.fonts.small, told).x, ui.theme.gap_px);
    ImGui::AlignTextToFramePadding();
    ImGui::PushFont(ui.theme.fonts.small);
    dim_text(ui, told);
    ImGui::PopFont();
    note_item(ui.rects, "candidates:count", told);
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
    const std::string words = heading(place.column);
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

// In the order of the table; the list's would take others.
void select_rows_through(Workspace& work, const std::vector<CandidateRow>& rows,
                         std::size_t place) {
    const auto row_of_place = [&rows](std::size_t wanted) {
        return std::ranges::find(rows, wanted, &CandidateRow::place);
    };
    auto from = row_of_place(work.selection.current);
    auto to = row_of_place(place);
    if (from == rows.end()) return select_only(work, place);
    if (to < from) std::swap(from, to);
    for (auto row = from; row <= to; ++row) {
        if (row->place != work.selection.current) work.selection.others.insert(row->place);
    }
}

void take_click(Ui& ui, Workspace& work, CandidatesState& state, std::size_t place) {
    const bool shift = ImGui::GetIO().KeyShift;
    const bool ctrl = ImGui::GetIO().KeyCtrl;
    ui.waiting.emplace_back([&work, &state, place, shift, ctrl] {
        if (shift) return select_rows_through(work, state.rows, place);
        ctrl ? toggle_selected(work, place) : select_only(work, place);
        work.selection.scroll_to_current = true;
    });
}

// A tick; hollow where it is of a preview.
void draw_picked_mark(const Theme& theme, ImVec2 centre, bool preview) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float r = 5.0F * theme.scale;
    if (preview) return list.AddCircle(centre, r, theme.text, 0, 1.5F * theme.hairline_px);
    list.AddCircleFilled(centre, r, theme.text);
}

std::string cell_words(const CandidateRow& row, CandidateColumn column) {
    const auto number = [](const std::optional<double>& value) {
        return value ? significant_digits(*value, 3) : std::string();
    };
    switch (column) {
        case CandidateColumn::amplitude:
            return number(row.amplitude_g);
        case CandidateColumn::carrier:
            return number(row.carrier_hz);
        case CandidateColumn::modulation:
            return number(row.modulation_hz);
        case CandidateColumn::duration:
            return number(row.duration_s);
        case CandidateColumn::nearest:
            return row.nearest_pm ? grouped(*row.nearest_pm) : std::string();
        default:
            return {};
    }
}

void draw_rhythm_cell(const Theme& theme, const CandidateRow& row, const Rect& cell) {
    if (!row.rhythm) return;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImFont* font = theme.fonts.small;
    const float y = cell.centre().y - text_size(font, "x").y / 2.0F;
    if (row.rhythm->empty())
        return draw_text(list, font, {cell.min.x, y}, theme.dim_text, "steady");
    const float each =
        std::min(8.0F * theme.scale, cell.width() / static_cast<float>(row.rhythm->size()));
    if (each < 2.0F * theme.scale) {
        const auto notes = static_cast<std::size_t>(std::ranges::count(*row.rhythm, 'x'));
        return draw_text(list, font, {cell.min.x, y}, theme.dim_text,
                         std::to_string(notes) + " notes");
    }
    const float half = 5.0F * theme.scale;
    draw_rhythm_cells(
        theme,
        {{cell.min.x, cell.centre().y - half},
         {cell.min.x + each * static_cast<float>(row.rhythm->size()), cell.centre().y + half}},
        *row.rhythm);
}

void draw_name_cell(const Theme& theme, const Vibration& vibration, const PatternLook& look,
                    const Rect& cell) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float s = theme.scale;
    draw_pattern_mark(list, theme, {cell.min.x + 5.0F * s, cell.centre().y}, 4.5F * s, look,
                      theme.pane);
    const float begin = cell.min.x + 15.0F * s;
    const std::string state = vibration.locked ? "  locked" : vibration.dropped ? "  dropped" : "";
    const float state_px = text_size(theme.fonts.small, state).x;
    const std::string name = shortened(theme.fonts.regular, vibration.name,
                                       std::max(0.0F, cell.max.x - begin - state_px));
    const ImVec2 size = text_size(theme.fonts.regular, name);
    const float y = cell.centre().y - size.y / 2.0F;
    draw_text(list, theme.fonts.regular, {begin, y},
              vibration.dropped ? theme.dim_text : theme.text, name);
    if (state.empty()) return;
    const float lower = size.y - text_size(theme.fonts.small, state).y;
    draw_text(list, theme.fonts.small, {begin + size.x, y + 0.8F * lower}, theme.dim_text, state);
}

void draw_cell(Ui& ui, Workspace& work, const CandidateRow& row, CandidateColumn column,
               const Rect& cell) {
    const Theme& theme = ui.theme;
    const Vibration& vibration = work.document.set.vibrations[row.place];
    switch (column) {
        case CandidateColumn::picture:
            return draw_thumbnail(ui, work, cell, vibration, look_of(ui, work, row.place).colour,
                                  shown_reach_g(work));
        case CandidateColumn::name:
            return draw_name_cell(theme, vibration, look_of(ui, work, row.place), cell);
        case CandidateColumn::rhythm:
            return draw_rhythm_cell(theme, row, cell);
        case CandidateColumn::picked:
            if (!row.picked) return;
            return draw_picked_mark(theme, cell.centre(), work.selection.is_pick_preview);
        default:
            break;
    }
    const std::string words = cell_words(row, column);
    const ImVec2 size = text_size(theme.fonts.regular, words);
    draw_text(*ImGui::GetWindowDrawList(), theme.fonts.regular,
              {cell.max.x - size.x, cell.centre().y - size.y / 2.0F}, theme.text, words);
}

// What a short name stands for, and who is closest.
std::string row_words(const Workspace& work, const CandidateRow& row) {
    const Vibration& vibration = work.document.set.vibrations[row.place];
    std::string words = vibration.name;
    const auto* pattern = std::get_if<Pattern>(&vibration.source);
    const auto& space = work.document.set.generator;
    if (vibration.generated && pattern != nullptr && space) {
        words += ": " + level_words(*space, *pattern);
    }
    if (!row.nearest_name.empty()) words += "\nClosest: " + row.nearest_name;
    return words + "\n" + kHoldHelp + ".";
}

void draw_row_ground(const Ui& ui, const Workspace& work, std::size_t place, const Rect& line) {
    const Theme& theme = ui.theme;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const bool current = place == work.selection.current;
    if (current || work.selection.others.contains(place)) {
        list.AddRectFilled(line.min, line.max, faded(theme.text, current ? 0.16F : 0.08F),
                           theme.rounding_px);
        if (current) draw_selection_frame(list, theme, line);
    } else if (work.selection.hovered_last == place) {
        list.AddRectFilled(line.min, line.max, theme.hover, theme.rounding_px);
    }
}

void draw_table_row(Ui& ui, Workspace& work, CandidatesState& state, const CandidateRow& row,
                    const std::vector<ColumnSpan>& places) {
    const float s = ui.theme.scale;
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const float width = std::max(1.0F, ImGui::GetContentRegionAvail().x);
    const Rect line = rect_at(corner, {width, kTableRowPx * s});
    const Vibration& vibration = work.document.set.vibrations[row.place];
    ImGui::PushID(static_cast<int>(row.place));
    ImGui::InvisibleButton("row", line.size());
    if (ImGui::IsItemClicked()) take_click(ui, work, state, row.place);
    if (ImGui::IsItemActive()) note_pressed(work, vibration);
    if (ImGui::IsItemHovered()) work.selection.hovered = row.place;
    note_item(ui.rects, "candidate:" + vibration.name, row.picked ? "picked" : "");
    draw_tooltip(ui, row_words(work, row).c_str());
    ImGui::PopID();
    draw_row_ground(ui, work, row.place, line);
    for (const ColumnSpan& place : places) {
        const Rect cell{{line.min.x + place.begin_px + 6.0F * s, line.min.y + 2.0F * s},
                        {line.min.x + place.end_px - 6.0F * s, line.max.y - 2.0F * s}};
        draw_cell(ui, work, row, place.column, cell);
    }
}

void follow_current_row(const Workspace& work, const std::vector<CandidateRow>& rows,
                        float row_px) {
    if (!work.selection.scroll_to_current) return;
    const auto place = std::ranges::find(rows, work.selection.current, &CandidateRow::place);
    if (place == rows.end()) return;
    const float at = static_cast<float>(place - rows.begin()) * row_px;
    const float top = ImGui::GetScrollY();
    if (at < top) ImGui::SetScrollY(at);
    const float height = ImGui::GetWindowHeight();
    if (at + row_px > top + height) ImGui::SetScrollY(at + row_px - height);
}

}  // namespace

void draw_candidates_panel(Ui& ui, Workspace& work, const ShownMap& shown_map,
                           CandidatesState& state) {
    const std::vector<CandidateRow>& rows = candidate_rows(work, shown_map, state);
    work.selection.table_order.clear();
    for (const CandidateRow& row : rows) work.selection.table_order.push_back(row.place);
    if (!ui.as_picture) draw_table_tools(ui, work, rows.size());
    const float scroll_px = ImGui::GetStyle().ScrollbarSize;
    const std::vector<ColumnSpan> places =
        column_places(ImGui::GetContentRegionAvail().x - scroll_px, ui.theme.scale);
    draw_headings(ui, state, places);
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(0.0F, 0.0F));
    if (ImGui::BeginChild("candidates")) {
        follow_current_row(work, rows, kTableRowPx * ui.theme.scale);
        ImGuiListClipper clipper;
        clipper.Begin(static_cast<int>(rows.size()));
        while (clipper.Step()) {
            for (int k = clipper.DisplayStart; k < clipper.DisplayEnd; ++k) {
                draw_table_row(ui, work, state, rows[static_cast<std::size_t>(k)], places);
            }
        }
        if (rows.empty()) {
            const bool none = work.document.set.vibrations.empty();
            draw_empty(*ImGui::GetWindowDrawList(), ui.theme, rest_of_pane(),
                       none ? "No patterns yet" : "None is as the filter says",
                       none ? "Press New, or Ctrl+G to generate some." : "Clear it to see all.");
        }
    }
    ImGui::EndChild();
    ImGui::PopStyleVar();
}

}  // namespace tact
