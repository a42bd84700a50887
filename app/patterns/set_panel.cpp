// The list of patterns: search, select, rename, reorder, lock.

#include <imgui.h>
// After imgui.h.
#include <imgui_stdlib.h>

#include <algorithm>
#include <cstdio>
#include <optional>

#include "app/document/editing.h"
#include "app/document/pattern_looks.h"
#include "app/patterns/set_panel.h"
#include "app/ui/widgets.h"
#include "viz/drawing/colour.h"
#include "viz/drawing/marks.h"
#include "viz/drawing/plot.h"

namespace tact {

namespace {

constexpr float kPatternRowPx = 25.0F;
constexpr const char* kDragKind = "tact-vibration";

// Which parts of a row there is room for, beside most of the names.
struct RowParts {
    float thumbnail_px = 0.0F;  // 0: none
    float strength_px = 0.0F;
};

// The strength goes first, then the thumbnail, then the ends of names.
RowParts row_parts(const Ui& ui, const Workspace& work, float row_px) {
    const float s = ui.theme.scale;
    const auto& all = work.document.set.vibrations;
    float widest = 0.0F;
    for (std::size_t k = 0; k < std::min<std::size_t>(all.size(), 500); ++k) {
        widest = std::max(widest, text_size(ui.theme.fonts.regular, all[k].name).x);
    }
    // One long name must not take the pictures of all.
    const float free = row_px - 32.0F * s - std::min(widest, 0.5F * row_px);
    const float least = 36.0F * s;
    const float most = std::min(76.0F * s, 0.28F * row_px);
    constexpr float kStrengthPx = 62.0F;
    if (free >= kStrengthPx * s + least) {
        return {std::min(free - kStrengthPx * s, most), kStrengthPx * s};
    }
    if (free >= least) return {std::min(free, most), 0.0F};
    return {};
}

void draw_toolbar(Ui& ui, Workspace& work) {
    if (ImGui::Button("New")) add_pattern(ui, work);
    note_item(ui.rects, "button:new");
    draw_tooltip(ui, "Add a pattern (Ctrl+N)");
    flow_on(button_width("Duplicate"), ui.theme.gap_px);
    ImGui::BeginDisabled(work.document.set.vibrations.empty());
    if (ImGui::Button("Duplicate")) duplicate_selected(ui, work);
    note_item(ui.rects, "button:duplicate");
    draw_tooltip(ui, "Copy the selected patterns (Ctrl+D)");
    ImGui::EndDisabled();
    flow_on(72.0F * ui.theme.scale, ui.theme.gap_px);
    ImGui::SetNextItemWidth(-1.0F);
    ImGui::InputTextWithHint("##search", "Search", &work.selection.search);
    note_item(ui.rects, "search");
}

std::string strength_text(const Vibration& vibration) {
    const auto* pattern = std::get_if<Pattern>(&vibration.source);
    if (pattern == nullptr) {
        return std::get<Measurement>(vibration.source).synthetic ? "synthetic" : "measured";
    }
    char text[32];
    std::snprintf(text, sizeof text, "%.3g g", pattern->amplitude_g);
    return text;
}

void drag_row(Ui& ui, Workspace& work, std::size_t index) {
    if (ImGui::BeginDragDropSource(ImGuiDragDropFlags_SourceNoPreviewTooltip)) {
        ImGui::SetDragDropPayload(kDragKind, &index, sizeof index);
        ImGui::EndDragDropSource();
    }
    if (ImGui::BeginDragDropTarget()) {
        if (const ImGuiPayload* payload = ImGui::AcceptDragDropPayload(kDragKind)) {
            const std::size_t from = *static_cast<const std::size_t*>(payload->Data);
            ui.waiting.emplace_back([&, from, index] { move_vibration(ui, work, from, index); });
        }
        ImGui::EndDragDropTarget();
    }
}

void draw_row_menu(Ui& ui, Workspace& work, PatternPanes& pattern_panes, std::size_t index) {
    if (!ImGui::BeginPopupContextItem("row menu")) return;
    if (index != work.selection.current && !work.selection.others.contains(index)) {
        select_only(work, index);
    }
    const Vibration& vibration = work.document.set.vibrations[index];
    if (ImGui::MenuItem("Rename", "F2")) begin_rename(work, pattern_panes, index);
    note_item(ui.rects, "row menu:Rename");
    // Once all rows are drawn: there may be fewer of them then.
    const auto item = [&](const char* text, const char* keys, std::function<void()> act) {
        if (ImGui::MenuItem(text, keys)) ui.waiting.push_back(std::move(act));
        note_item(ui.rects, std::string("row menu:") + text);
    };
    item(vibration.locked ? "Unlock" : "Lock", "", [&] { toggle_locked(ui, work); });
    item(vibration.dropped ? "Take back" : "Drop", "", [&] { toggle_dropped(ui, work); });
    item("Duplicate", "Ctrl+D", [&] { duplicate_selected(ui, work); });
    item("Copy", "Ctrl+C", [&] { copy_selected(ui, work); });
    item("Delete", "Del", [&] { remove_selected(ui, work); });
    ImGui::EndPopup();
}

// The text field that stands in the row while it is renamed. Enter and leaving it take the name;
// Esc brings the one before back.
void draw_rename(Ui& ui, Workspace& work, PatternPanes& pattern_panes, std::size_t index) {
    SetPanelState& state = pattern_panes.list;
    ImGui::SetNextItemWidth(-1.0F);
    if (!state.rename_begun) ImGui::SetKeyboardFocusHere();
    ImGui::InputText("##rename", &state.rename_text, ImGuiInputTextFlags_AutoSelectAll);
    note_item(ui.rects, "rename", state.rename_text);
    if (ImGui::IsItemActive()) state.rename_begun = true;
    if (ImGui::IsItemActive() || !state.rename_begun) return;
    state.renaming.reset();
    const std::string before = work.document.set.vibrations[index].name;
    const std::string name = state.rename_text;
    ui.waiting.emplace_back([&, before, name] {
        const auto place = place_named(work.document.set, before);
        if (place) rename_vibration(ui, work, *place, name);
    });
}

// Strength and thumbnail at the right end; where they begin. A name that needs the room has it.
float draw_row_end(const Ui& ui, Workspace& work, const Vibration& vibration,
                   const PatternLook& look, const Rect& row, float name_end,
                   const RowParts& parts) {
    const Theme& theme = ui.theme;
    const float s = theme.scale;
    float end = row.max.x - 6.0F * s;
    if (parts.strength_px > 0.0F && name_end <= row.max.x - parts.strength_px) {
        const std::string strength = strength_text(vibration);
        const ImVec2 size = text_size(theme.fonts.small, strength);
        draw_text(*ImGui::GetWindowDrawList(), theme.fonts.small,
                  {end - size.x, row.centre().y - size.y / 2.0F}, theme.dim_text, strength);
        end = row.max.x - parts.strength_px;
    }
    const float thumbnail_end = std::min(end, row.max.x - parts.strength_px);
    const float begin = thumbnail_end - parts.thumbnail_px;
    if (parts.thumbnail_px <= 0.0F || name_end > begin) return end;
    draw_thumbnail(ui, work, {{begin, row.min.y + 5.0F * s}, {thumbnail_end, row.max.y - 5.0F * s}},
                   vibration, look.colour);
    return begin;
}

void draw_row_content(Ui& ui, Workspace& work, std::size_t index, const Rect& row,
                      const RowParts& parts) {
    const Vibration& vibration = work.document.set.vibrations[index];
    const Theme& theme = ui.theme;
    const float s = theme.scale;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const bool current = index == work.selection.current;
    if (current || work.selection.others.contains(index)) {
        list.AddRectFilled(row.min, row.max, faded(theme.accent, current ? 0.28F : 0.16F),
                           theme.rounding_px);
    } else if (work.selection.hovered_last == index) {
        list.AddRectFilled(row.min, row.max, theme.hover, theme.rounding_px);
    }
    const float middle = row.centre().y;
    const float text_y = middle - ImGui::GetTextLineHeight() / 2.0F;
    const PatternLook look = look_of(ui, work, index);
    draw_pattern_mark(list, theme, {row.min.x + 12.0F * s, middle}, 5.5F * s, look, theme.pane);

    const float name_begin = row.min.x + 26.0F * s;
    std::string name = vibration.name;
    if (vibration.locked) name += "  (locked)";
    if (vibration.dropped) name += "  (dropped)";
    const float name_end = name_begin + text_size(theme.fonts.regular, name).x + 6.0F * s;
    const float end = draw_row_end(ui, work, vibration, look, row, name_end, parts);
    const std::string shown =
        shortened(theme.fonts.regular, name, std::max(0.0F, end - name_begin - 5.0F * s));
    draw_text(list, theme.fonts.regular, {name_begin, text_y}, theme.text, shown);
    if (work.selection.too_close.contains(vibration.name)) {
        list.AddCircle({row.min.x + 12.0F * s, middle}, 9.0F * s, theme.warning, 0,
                       1.5F * theme.hairline_px);
    }
    const ImVec2 corner{name_begin, text_y};
    note_rect(ui.rects, "row name:" + vibration.name, corner,
              corner + text_size(theme.fonts.regular, shown), shown);
}

void draw_row(Ui& ui, Workspace& work, PatternPanes& pattern_panes, std::size_t index,
              const RowParts& parts) {
    const float height = kPatternRowPx * ui.theme.scale;
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    ImGui::PushID(static_cast<int>(index));
    if (pattern_panes.list.renaming == index &&
        pattern_panes.list.renaming_in == work.document_number) {
        draw_rename(ui, work, pattern_panes, index);
        ImGui::PopID();
        return;
    }
    const float width = std::max(1.0F, ImGui::GetContentRegionAvail().x);
    const bool pressed = ImGui::InvisibleButton("row", {width, height});
    if (index == work.selection.current) note_stop(ui.rects.tab_order);  // for all of them
    if (ImGui::IsItemClicked() || (pressed && ui.keyboard_mode)) {
        pattern_panes.list.clicked = {index, ImGui::GetIO().KeyShift, ImGui::GetIO().KeyCtrl};
    }
    if (ImGui::IsItemHovered()) {
        work.selection.hovered = index;
        if (ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) {
            begin_rename(work, pattern_panes, index);
        }
    }
    const Rect row = rect_at(corner, {width, height});
    note_rect(ui.rects, "row:" + work.document.set.vibrations[index].name, row.min, row.max);
    drag_row(ui, work, index);
    draw_row_menu(ui, work, pattern_panes, index);
    draw_row_content(ui, work, index, row, parts);
    ImGui::PopID();
}

void scroll_to_current(const Ui& ui, Workspace& work, const std::vector<std::size_t>& rows) {
    if (!work.selection.scroll_to_current) return;
    work.selection.scroll_to_current = false;
    const auto place = std::ranges::find(rows, work.selection.current) - rows.begin();
    const float row_height = kPatternRowPx * ui.theme.scale + ImGui::GetStyle().ItemSpacing.y;
    const float target = static_cast<float>(place) * row_height;
    const float top = ImGui::GetScrollY();
    if (target < top) ImGui::SetScrollY(target);
    if (target + row_height > top + ImGui::GetWindowHeight()) {
        ImGui::SetScrollY(target + row_height - ImGui::GetWindowHeight());
    }
}

void draw_rows(Ui& ui, Workspace& work, PatternPanes& pattern_panes) {
    const std::vector<std::size_t> rows = listed_indices(work);
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(0.0F, 1.0F));
    if (ImGui::BeginChild("rows")) {
        scroll_to_current(ui, work, rows);
        const RowParts parts = row_parts(ui, work, ImGui::GetContentRegionAvail().x);
        ImGuiListClipper clipper;
        clipper.Begin(static_cast<int>(rows.size()));
        while (clipper.Step()) {
            for (int k = clipper.DisplayStart; k < clipper.DisplayEnd; ++k) {
                draw_row(ui, work, pattern_panes, rows[static_cast<std::size_t>(k)], parts);
            }
        }
        if (rows.empty()) {
            const bool none = work.document.set.vibrations.empty();
            draw_empty(*ImGui::GetWindowDrawList(), ui.theme, rest_of_pane(),
                       none ? "No patterns yet" : "No pattern has this in its name",
                       none ? "Press New, or drop a folder of .txt or .wav files here."
                            : "Clear the search to see all of them.");
        }
    }
    ImGui::EndChild();
    ImGui::PopStyleVar();
}

}  // namespace

void begin_rename(const Workspace& work, PatternPanes& pattern_panes, std::size_t index) {
    pattern_panes.list.renaming = index;
    pattern_panes.list.renaming_in = work.document_number;
    pattern_panes.list.rename_text = work.document.set.vibrations[index].name;
    pattern_panes.list.rename_begun = false;
}

void draw_set_panel(Ui& ui, Workspace& work, PatternPanes& pattern_panes) {
    draw_toolbar(ui, work);
    draw_rows(ui, work, pattern_panes);
}

}  // namespace tact
