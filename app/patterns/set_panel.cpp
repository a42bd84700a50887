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
RowParts row_parts(const App& app, float row_px) {
    const float s = app.theme.scale;
    const auto& all = app.document.set.vibrations;
    float widest = 0.0F;
    for (std::size_t k = 0; k < std::min<std::size_t>(all.size(), 500); ++k) {
        widest = std::max(widest, text_size(app.theme.fonts.regular, all[k].name).x);
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

void draw_toolbar(App& app) {
    if (ImGui::Button("New")) add_pattern(app);
    note_item(app.rects, "button:new");
    draw_tooltip(app, "Add a pattern (Ctrl+N)");
    flow_on(button_width("Duplicate"), app.theme.gap_px);
    ImGui::BeginDisabled(app.document.set.vibrations.empty());
    if (ImGui::Button("Duplicate")) duplicate_selected(app);
    note_item(app.rects, "button:duplicate");
    draw_tooltip(app, "Copy the selected patterns (Ctrl+D)");
    ImGui::EndDisabled();
    flow_on(72.0F * app.theme.scale, app.theme.gap_px);
    ImGui::SetNextItemWidth(-1.0F);
    ImGui::InputTextWithHint("##search", "Search", &app.selection.search);
    note_item(app.rects, "search");
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

void drag_row(App& app, std::size_t index) {
    if (ImGui::BeginDragDropSource(ImGuiDragDropFlags_SourceNoPreviewTooltip)) {
        ImGui::SetDragDropPayload(kDragKind, &index, sizeof index);
        ImGui::EndDragDropSource();
    }
    if (ImGui::BeginDragDropTarget()) {
        if (const ImGuiPayload* payload = ImGui::AcceptDragDropPayload(kDragKind)) {
            const std::size_t from = *static_cast<const std::size_t*>(payload->Data);
            app.waiting.emplace_back([&app, from, index] { move_vibration(app, from, index); });
        }
        ImGui::EndDragDropTarget();
    }
}

void begin_rename(App& app, std::size_t index) {
    app.set_panel.renaming = index;
    app.set_panel.renaming_in = app.document_number;
    app.set_panel.rename_text = app.document.set.vibrations[index].name;
    app.set_panel.rename_begun = false;
}

void draw_row_menu(App& app, std::size_t index) {
    if (!ImGui::BeginPopupContextItem("row menu")) return;
    if (index != app.selection.current && !app.selection.others.contains(index)) {
        select_only(app, index);
    }
    const Vibration& vibration = app.document.set.vibrations[index];
    if (ImGui::MenuItem("Rename", "F2")) begin_rename(app, index);
    note_item(app.rects, "row menu:Rename");
    // Once all rows are drawn: there may be fewer of them then.
    const auto item = [&app](const char* text, const char* keys, std::function<void()> act) {
        if (ImGui::MenuItem(text, keys)) app.waiting.push_back(std::move(act));
        note_item(app.rects, std::string("row menu:") + text);
    };
    item(vibration.locked ? "Unlock" : "Lock", "", [&app] { toggle_locked(app); });
    item(vibration.dropped ? "Take back" : "Drop", "", [&app] { toggle_dropped(app); });
    item("Duplicate", "Ctrl+D", [&app] { duplicate_selected(app); });
    item("Copy", "Ctrl+C", [&app] { copy_selected(app); });
    item("Delete", "Del", [&app] { remove_selected(app); });
    ImGui::EndPopup();
}

// The text field that stands in the row while it is renamed. Enter and leaving it take the name;
// Esc brings the one before back.
void draw_rename(App& app, std::size_t index) {
    SetPanelState& state = app.set_panel;
    ImGui::SetNextItemWidth(-1.0F);
    if (!state.rename_begun) ImGui::SetKeyboardFocusHere();
    ImGui::InputText("##rename", &state.rename_text, ImGuiInputTextFlags_AutoSelectAll);
    note_item(app.rects, "rename", state.rename_text);
    if (ImGui::IsItemActive()) state.rename_begun = true;
    if (ImGui::IsItemActive() || !state.rename_begun) return;
    state.renaming.reset();
    const std::string before = app.document.set.vibrations[index].name;
    const std::string name = state.rename_text;
    app.waiting.emplace_back([&app, before, name] {
        const auto place = place_named(app.document.set, before);
        if (place) rename_vibration(app, *place, name);
    });
}

// Strength and thumbnail at the right end; where they begin. A name that needs the room has it.
float draw_row_end(App& app, const Vibration& vibration, const PatternLook& look, const Rect& row,
                   float name_end, const RowParts& parts) {
    const Theme& theme = app.theme;
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
    draw_thumbnail(app, {{begin, row.min.y + 5.0F * s}, {thumbnail_end, row.max.y - 5.0F * s}},
                   vibration, look.colour);
    return begin;
}

void draw_row_content(App& app, std::size_t index, const Rect& row, const RowParts& parts) {
    const Vibration& vibration = app.document.set.vibrations[index];
    const Theme& theme = app.theme;
    const float s = theme.scale;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const bool current = index == app.selection.current;
    if (current || app.selection.others.contains(index)) {
        list.AddRectFilled(row.min, row.max, faded(theme.accent, current ? 0.28F : 0.16F),
                           theme.rounding_px);
    } else if (app.selection.hovered_last == index) {
        list.AddRectFilled(row.min, row.max, theme.hover, theme.rounding_px);
    }
    const float middle = row.centre().y;
    const float text_y = middle - ImGui::GetTextLineHeight() / 2.0F;
    const PatternLook look = look_of(app, index);
    draw_pattern_mark(list, theme, {row.min.x + 12.0F * s, middle}, 5.5F * s, look, theme.pane);

    const float name_begin = row.min.x + 26.0F * s;
    std::string name = vibration.name;
    if (vibration.locked) name += "  (locked)";
    if (vibration.dropped) name += "  (dropped)";
    const float name_end = name_begin + text_size(theme.fonts.regular, name).x + 6.0F * s;
    const float end = draw_row_end(app, vibration, look, row, name_end, parts);
    const std::string shown =
        shortened(theme.fonts.regular, name, std::max(0.0F, end - name_begin - 5.0F * s));
    draw_text(list, theme.fonts.regular, {name_begin, text_y}, theme.text, shown);
    if (app.selection.too_close.contains(vibration.name)) {
        list.AddCircle({row.min.x + 12.0F * s, middle}, 9.0F * s, theme.warning, 0,
                       1.5F * theme.hairline_px);
    }
    const ImVec2 corner{name_begin, text_y};
    note_rect(app.rects, "row name:" + vibration.name, corner,
              corner + text_size(theme.fonts.regular, shown), shown);
}

void draw_row(App& app, std::size_t index, const RowParts& parts) {
    const float height = kPatternRowPx * app.theme.scale;
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    ImGui::PushID(static_cast<int>(index));
    if (app.set_panel.renaming == index && app.set_panel.renaming_in == app.document_number) {
        draw_rename(app, index);
        ImGui::PopID();
        return;
    }
    const float width = std::max(1.0F, ImGui::GetContentRegionAvail().x);
    ImGui::InvisibleButton("row", {width, height});
    if (ImGui::IsItemClicked()) {
        app.set_panel.clicked = {index, ImGui::GetIO().KeyShift, ImGui::GetIO().KeyCtrl};
    }
    if (ImGui::IsItemHovered()) {
        app.selection.hovered = index;
        if (ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) {
            begin_rename(app, index);
        }
    }
    const Rect row = rect_at(corner, {width, height});
    note_rect(app.rects, "row:" + app.document.set.vibrations[index].name, row.min, row.max);
    drag_row(app, index);
    draw_row_menu(app, index);
    draw_row_content(app, index, row, parts);
    ImGui::PopID();
}

void scroll_to_current(App& app, const std::vector<std::size_t>& rows) {
    if (!app.selection.scroll_to_current) return;
    app.selection.scroll_to_current = false;
    const auto place = std::ranges::find(rows, app.selection.current) - rows.begin();
    const float row_height = kPatternRowPx * app.theme.scale + ImGui::GetStyle().ItemSpacing.y;
    const float target = static_cast<float>(place) * row_height;
    const float top = ImGui::GetScrollY();
    if (target < top) ImGui::SetScrollY(target);
    if (target + row_height > top + ImGui::GetWindowHeight()) {
        ImGui::SetScrollY(target + row_height - ImGui::GetWindowHeight());
    }
}

void draw_rows(App& app) {
    const std::vector<std::size_t> rows = listed_indices(app);
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(0.0F, 1.0F));
    if (ImGui::BeginChild("rows")) {
        scroll_to_current(app, rows);
        const RowParts parts = row_parts(app, ImGui::GetContentRegionAvail().x);
        ImGuiListClipper clipper;
        clipper.Begin(static_cast<int>(rows.size()));
        while (clipper.Step()) {
            for (int k = clipper.DisplayStart; k < clipper.DisplayEnd; ++k) {
                draw_row(app, rows[static_cast<std::size_t>(k)], parts);
            }
        }
        if (rows.empty()) {
            const bool none = app.document.set.vibrations.empty();
            draw_empty(*ImGui::GetWindowDrawList(), app.theme, rest_of_pane(),
                       none ? "No patterns yet" : "No pattern has this in its name",
                       none ? "Press New, or drop a folder of .txt or .wav files here."
                            : "Clear the search to see all of them.");
        }
    }
    ImGui::EndChild();
    ImGui::PopStyleVar();
}

}  // namespace

void draw_set_panel(App& app) {
    draw_toolbar(app);
    draw_rows(app);
}

}  // namespace tact
