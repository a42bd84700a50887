#include "app/candidates/candidates.h"

#include <imgui.h>
// After imgui.h.
#include <imgui_stdlib.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>

#include "app/candidates/parts.h"
#include "app/document/editing.h"
#include "app/document/workspace.h"
#include "app/ui/widgets.h"
#include "model/design_space/candidates.h"
#include "model/dissimilarity/dissimilarity.h"
#include "model/text/numbers.h"
#include "viz/drawing/colour.h"
#include "viz/drawing/marks.h"
#include "viz/drawing/plot.h"

namespace tact {

namespace {

// Few rows share what room there is: their pictures grow.
float table_row_px(const Ui& ui, float room_px, std::size_t rows) {
    const float least = 24.0F * ui.theme.scale;
    const float most = 36.0F * ui.theme.scale;
    const auto count = static_cast<float>(std::max<std::size_t>(rows, 1));
    return std::clamp(std::floor(room_px / count), least, most);
}

void draw_table_tools(Ui& ui, Workspace& work, std::size_t listed) {
    Selection& selection = work.selection;
    const std::string count = std::to_string(selection.picked.size());
    const std::string only = selection.picked.empty() ? "only picked" : "only picked: " + count;
    const Vibration* current = current_vibration(work);
    const char* lock = current != nullptr && current->locked ? "Unlock" : "Lock";
    const char* drop = current != nullptr && current->dropped ? "Include" : "Exclude";
    // It leaves room for what is pressed beside it.
    const float beside = chip_width(ui, only.c_str()) + button_width(lock) + button_width(drop) +
                         3.0F * ui.theme.gap_px;
    const float room = ImGui::GetContentRegionAvail().x;
    const float s = ui.theme.scale;
    ImGui::SetNextItemWidth(std::min(std::clamp(room - beside, 96.0F * s, 170.0F * s), room));
    ImGui::InputTextWithHint("##filter", "60 Hz, x--x, a name", &selection.search);
    note_item(ui.rects, "candidates:filter", selection.search);
    flow_on(chip_width(ui, only.c_str()), ui.theme.gap_px);
    if (toggle(ui,
               {.id = "candidates:only picked",
                .label = only,
                .value = selection.only_picked ? "on" : "off"},
               selection.only_picked)) {
        selection.only_picked = !selection.only_picked;
    }
    const auto action = [&](const Item& item, auto act) {
        flow_on(button_width(item.label.c_str()), ui.theme.gap_px);
        if (button(ui, item)) ui.waiting.emplace_back([&ui, &work, act] { act(ui, work); });
    };
    if (current == nullptr) return;
    action({.id = "candidates:lock",
            .label = lock,
            .tip = "All selected rows: picked in every subset, and not edited."},
           toggle_locked);
    action(
        {.id = "candidates:drop", .label = drop, .tip = "All selected rows: picked in no subset."},
        toggle_dropped);
    if (const std::size_t unfelt = unfelt_indices(work).size(); unfelt > 0) {
        action({.id = "candidates:exclude unfelt",
                .label = "Exclude all not felt (" + std::to_string(unfelt) + ")",
                .tip = "No receptor of the model answers to them. Locked ones stay."},
               exclude_unfelt);
    }
    const std::string told = std::to_string(listed) + " of " +
                             std::to_string(work.document.set.vibrations.size()) + ", " +
                             std::to_string(selected_indices(work).size()) + " selected";
    dim_text_beside(ui, {.id = "candidates:count", .text = told});
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

// What a short name stands for, and who is closest.
std::string row_words(const Workspace& work, const CandidateRow& row) {
    const Vibration& vibration = work.document.set.vibrations[row.place];
    std::string words = vibration.name;
    const auto* pattern = std::get_if<Pattern>(&vibration.source);
    const auto& space = work.document.set.generator;
    if (vibration.generated && pattern != nullptr && space) {
        words += ": " + level_words(*space, *pattern);
    }
    if (!row.further_hz.empty() && row.carrier_hz) {
        words += "\nCarriers: " + significant_digits(*row.carrier_hz, 3);
        for (const double hz : row.further_hz) words += " + " + significant_digits(hz, 3);
        words += " Hz";
    }
    if (!row.nearest_name.empty()) words += "\nClosest: " + row.nearest_name;
    return words + "\n" + kHoldHelp + ".";
}

PatternAction draw_table_row(Ui& ui, Workspace& work, CandidatesState& state,
                             const CandidateRow& row, const std::vector<ColumnSpan>& places,
                             float row_px) {
    const float s = ui.theme.scale;
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const float width = std::max(1.0F, ImGui::GetContentRegionAvail().x);
    const Rect line = rect_at(corner, {width, row_px});
    const Vibration& vibration = work.document.set.vibrations[row.place];
    ImGui::PushID(static_cast<int>(row.place));
    ImGui::InvisibleButton("row", line.size());
    if (ImGui::IsItemClicked()) take_click(ui, work, state, row.place);
    if (ImGui::IsItemActive()) note_pressed(work, vibration);
    if (ImGui::IsItemHovered()) work.selection.hovered = row.place;
    say_of_last_item(ui, {.id = "candidate:" + vibration.name,
                          .text = row.picked ? "picked" : "",
                          .tip = row_words(work, row)});
    const PatternAction action = draw_row_menu(ui, work, row.place);
    ImGui::PopID();
    draw_row_ground(ui, work, row.place, line);
    for (const ColumnSpan& place : places) {
        const Rect cell{{line.min.x + place.begin_px + 6.0F * s, line.min.y + 2.0F * s},
                        {line.min.x + place.end_px - 6.0F * s, line.max.y - 2.0F * s}};
        draw_cell(ui, work, row, place.column, cell);
    }
    return action;
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

// PM is a rank among the pairs, so at most their number.
float nearest_px(const Ui& ui, const Workspace& work) {
    const auto pairs = static_cast<double>(pair_count(work.document.set.vibrations.size()));
    return text_size(ui.theme.fonts.regular, grouped(pairs)).x / ui.theme.scale + 12.0F;
}

}  // namespace

PatternAction draw_candidates_panel(Ui& ui, Workspace& work, const ShownMap& shown_map,
                                    CandidatesState& state) {
    PatternAction action = PatternAction::none;
    const std::vector<CandidateRow>& rows = candidate_rows(work, shown_map, state);
    work.selection.table_order.clear();
    for (const CandidateRow& row : rows) work.selection.table_order.push_back(row.place);
    if (!ui.as_picture) draw_table_tools(ui, work, rows.size());
    const float scroll_px = ImGui::GetStyle().ScrollbarSize;
    const std::vector<ColumnSpan> places = column_places(
        ImGui::GetContentRegionAvail().x - scroll_px, ui.theme.scale, nearest_px(ui, work));
    draw_headings(ui, state, places);
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(0.0F, 0.0F));
    if (ImGui::BeginChild("candidates")) {
        const float row_px = table_row_px(ui, ImGui::GetContentRegionAvail().y, rows.size());
        follow_current_row(work, rows, row_px);
        ImGuiListClipper clipper;
        clipper.Begin(static_cast<int>(rows.size()));
        while (clipper.Step()) {
            for (int k = clipper.DisplayStart; k < clipper.DisplayEnd; ++k) {
                const CandidateRow& row = rows[static_cast<std::size_t>(k)];
                const PatternAction asked = draw_table_row(ui, work, state, row, places, row_px);
                if (asked != PatternAction::none) action = asked;
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
    return action;
}

}  // namespace tact
