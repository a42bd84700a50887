// The list of patterns: search, select, rename, reorder, lock.

#include <imgui.h>
// After imgui.h.
#include <imgui_stdlib.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <optional>

#include "app/document/editing.h"
#include "app/document/workspace.h"
#include "app/patterns/patterns.h"
#include "app/ui/widgets.h"
#include "model/text/numbers.h"
#include "viz/drawing/colour.h"
#include "viz/drawing/imgui_versions.h"
#include "viz/drawing/marks.h"
#include "viz/drawing/plot.h"

namespace tact {

namespace {

constexpr float kLeastRowPx = 25.0F;
constexpr float kMostRowPx = 40.0F;
constexpr float kMarkPx = 19.0F;  // from its middle: its rings leave the bar of picked patterns
                                  // free
constexpr float kNamePx = 33.0F;  // left edge of names
constexpr const char* kDragKind = "tact-vibration";
constexpr const char* kUnfelt = "not felt";

// Width of each part of a row. The picture is always shown: in a narrow row the strength is left
// out first, then the ends of names.
struct RowParts {
    float height_px = 0.0F;
    float thumbnail_px = 0.0F;
    float strength_px = 0.0F;
    bool has_length = false;
    bool in_two = false;  // strength and length are stacked
};

RowParts row_parts(const Ui& ui, const Workspace& work, ImVec2 room, std::size_t rows) {
    const float s = ui.theme.scale;
    const auto& all = work.document.set.vibrations;
    float widest = 0.0F;
    for (std::size_t k = 0; k < std::min<std::size_t>(all.size(), 500); ++k) {
        widest = std::max(widest, text_size(ui.theme.fonts.regular, all[k].name).x +
                                      state_signs_px(ui.theme, all[k]));
    }
    const float each = room.y / static_cast<float>(std::max<std::size_t>(rows, 1)) - 1.0F;
    RowParts parts;
    parts.height_px = std::floor(std::clamp(each, kLeastRowPx * s, kMostRowPx * s));
    // One long name must not take the room of all pictures.
    const float free = room.x - (kNamePx + 6.0F) * s - std::min(widest, 0.34F * room.x);
    const float least = 60.0F * s;
    constexpr float kStrengthPx = 58.0F;
    constexpr float kWithLengthPx = 104.0F;
    parts.in_two = parts.height_px >= 2.0F * text_size(ui.theme.fonts.small, "0").y + 2.0F * s;
    const float wanted = (parts.in_two ? kStrengthPx : kWithLengthPx) * s;
    parts.has_length = parts.in_two || free >= wanted + least;
    const float strength = parts.has_length ? wanted : kStrengthPx * s;
    if (free >= strength + least) parts.strength_px = strength;
    parts.thumbnail_px = std::max(std::min(least, 0.4F * room.x), free - parts.strength_px);
    return parts;
}

std::string scale_text(const Workspace& work) {
    return work.own_heights ? "own heights"
                            : "\u00b1" + significant_digits(work.cache.reach_g, 3) + " g";
}

// One scale of g for all waveforms, or one for each.
void draw_scale_switch(Ui& ui, Workspace& work) {
    bool& own = work.own_heights;
    const std::string text = scale_text(work);
    flow_on(chip_width(ui, text.c_str()), ui.theme.gap_px);
    const char* tip = own ? "Each waveform fills its row. Press to draw all of them on one scale."
                          : "All waveforms are drawn on this one scale, so that what is stronger "
                            "looks stronger. Press to draw each to its own height.";
    if (toggle(ui, {.id = "button:heights", .label = text, .tip = tip}, !own)) own = !own;
}

constexpr float kLeastSearchPx = 72.0F;

// The typed text stays readable: switches before it in the line disappear in order of use. A switch
// that filters stays.
struct ToolbarParts {
    bool heights = true;
    bool picked = true;
};

ToolbarParts toolbar_parts(const Ui& ui, const Workspace& work) {
    const auto& selection = work.selection;
    ToolbarParts parts{true, !selection.picked.empty()};
    if (selection.search.empty()) return parts;
    const float s = ui.theme.scale;
    const float gap = ui.theme.gap_px;
    const float typed = text_size(ui.theme.fonts.regular, selection.search).x +
                        2.0F * ImGui::GetStyle().FramePadding.x + gap;
    const float wanted = std::clamp(typed, kLeastSearchPx * s, 180.0F * s);
    const auto left_px = [&] {
        float used = button_width("New") + gap + button_width("Duplicate") + gap;
        if (parts.heights) used += chip_width(ui, scale_text(work).c_str()) + gap;
        if (parts.picked) used += chip_width(ui, "picked") + gap;
        return ImGui::GetContentRegionAvail().x - used;
    };
    if (left_px() < kLeastSearchPx * s) return parts;  // it has a separate line
    if (left_px() < wanted && !selection.only_picked) parts.picked = false;
    if (left_px() < wanted) parts.heights = false;
    return parts;
}

void draw_toolbar(Ui& ui, Workspace& work) {
    const ToolbarParts parts = toolbar_parts(ui, work);
    if (primary_button(ui, {.id = "button:new", .label = "New", .tip = "Add a pattern (Ctrl+N)"})) {
        add_pattern(ui, work);
    }
    flow_on(button_width("Duplicate"), ui.theme.gap_px);
    if (button(ui, {.id = "button:duplicate",
                    .label = "Duplicate",
                    .tip = "Copy the selected patterns (Ctrl+D)",
                    .enabled = !work.document.set.vibrations.empty()})) {
        duplicate_selected(ui, work);
    }
    if (parts.heights) draw_scale_switch(ui, work);
    if (parts.picked) {
        flow_on(chip_width(ui, "picked"), ui.theme.gap_px);
        bool& only = work.selection.only_picked;
        if (toggle(
                ui,
                {.id = "button:only picked",
                 .label = "picked",
                 .tip = "Only those of the most distinct subset, which have a bar at their left.",
                 .value = only ? "on" : "off"},
                only)) {
            only = !only;
        }
    }
    flow_on(kLeastSearchPx * ui.theme.scale, ui.theme.gap_px);
    ImGui::SetNextItemWidth(-1.0F);
    ImGui::InputTextWithHint("##search", "Search", &work.selection.search);
    note_item(ui.rects, "search");
}

// "0.3 g", the peak of the felt waveform; "measured"; "stale" and "edited" if it has changed since
// it was measured or rated.
std::string strength_text(Workspace& work, const Vibration& vibration) {
    const std::string mark = mark_in_list(work.stale, vibration.name);
    if (!mark.empty()) return mark;
    if (const auto* twin = std::get_if<Measurement>(&vibration.source)) {
        return twin->synthetic ? "synthetic" : "measured";
    }
    // Until it is rendered for the first time, nobody knows.
    if (!work.cache.entries.contains(vibration.name)) return {};
    return significant_digits(peak_in_time(work.cache, vibration), 2) + " g";
}

// Explanation of a row's mark; empty: no mark.
std::string words_on_mark(const Workspace& work, const Vibration& vibration) {
    const std::string& name = vibration.name;
    if (mark_in_list(work.stale, name).empty()) return {};
    const auto* twin = std::get_if<Measurement>(&vibration.source);
    if (twin == nullptr) return "Was rated before it was edited.\n";
    return "Measures " + twin->measures + words_on_twin(work.stale, name) + ".\n";
}

// The place at which the dragged row would land.
void draw_drop_line(Ui& ui, float y, const Rect& row) {
    const float half = ui.theme.scale;
    const Rect line{{row.min.x, y - half}, {row.max.x, y + half}};
    ImGui::GetWindowDrawList()->AddRectFilled(line.min, line.max, ui.theme.accent, half);
    note_rect(ui.rects, "drop line", line.min, line.max);
}

void drag_row(Ui& ui, Workspace& work, std::size_t index, const Rect& row) {
    if (ImGui::BeginDragDropSource(ImGuiDragDropFlags_SourceNoPreviewTooltip)) {
        ImGui::SetDragDropPayload(kDragKind, &index, sizeof index);
        ImGui::EndDragDropSource();
    }
    if (!ImGui::BeginDragDropTarget()) return;
    constexpr ImGuiDragDropFlags kFlags =
        ImGuiDragDropFlags_AcceptNoDrawDefaultRect | ImGuiDragDropFlags_AcceptBeforeDelivery;
    if (const ImGuiPayload* payload = ImGui::AcceptDragDropPayload(kDragKind, kFlags)) {
        const std::size_t from = *static_cast<const std::size_t*>(payload->Data);
        if (payload->IsDelivery()) {
            ui.waiting.emplace_back([&, from, index] { move_vibration(ui, work, from, index); });
        } else if (from != index) {
            draw_drop_line(ui, from < index ? row.max.y : row.min.y, row);
        }
    }
    ImGui::EndDragDropTarget();
}

// The text field in a row while it is renamed. Enter and leaving it accept the name; Esc restores
// the old one.
void draw_rename(Ui& ui, Workspace& work, PatternPanes& pattern_panes, std::size_t index) {
    SetPanelState& state = pattern_panes.list;
    ImGui::SetNextItemWidth(-1.0F);
    if (!state.rename_begun) focus_next_item();
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

// The warning that a pattern is not felt, over the picture, which every row has room for.
void draw_unfelt(Ui& ui, const Workspace& work, const Vibration& vibration, const Rect& picture) {
    if (!work.selection.unfelt.contains(vibration.name)) return;
    const Theme& theme = ui.theme;
    const ImVec2 size = text_size(theme.fonts.small, kUnfelt);
    const ImVec2 centre = picture.centre();
    const ImVec2 pad{4.0F * theme.scale, theme.scale};
    const Rect pill{centre - size * 0.5F - pad, centre + size * 0.5F + pad};
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled(pill.min, pill.max, theme.pane, theme.rounding_px);
    list.AddRect(pill.min, pill.max, theme.warning, theme.rounding_px, 0, theme.hairline_px);
    draw_text(list, theme.fonts.small, centre - size * 0.5F, theme.warning, kUnfelt);
    note_rect(ui.rects, "not felt:" + vibration.name, pill.min, pill.max);
}

// A bar at the left end of picked patterns, inside the frame of a selected row; fainter in a
// preview.
void draw_picked_edge(Ui& ui, const Workspace& work, const Vibration& vibration, const Rect& row) {
    if (!work.selection.picked.contains(vibration.name)) return;
    const bool preview = work.selection.is_pick_preview;
    const float s = ui.theme.scale;
    const Rect edge{{row.min.x + 4.0F * s, row.min.y + 4.0F * s},
                    {row.min.x + 7.0F * s, row.max.y - 4.0F * s}};
    ImGui::GetWindowDrawList()->AddRectFilled(
        edge.min, edge.max, faded(ui.theme.text, preview ? 0.4F : 0.85F), 1.5F * s);
    note_rect(ui.rects, "picked:" + vibration.name, edge.min, edge.max,
              preview ? "preview" : "exact");
}

// Strength and thumbnail at the right end; returns their left edge.
float draw_row_end(Ui& ui, Workspace& work, const Vibration& vibration, const PatternLook& look,
                   const Rect& row, const RowParts& parts) {
    const Theme& theme = ui.theme;
    const float s = theme.scale;
    const float edge = row.max.x - 6.0F * s;
    if (parts.strength_px > 0.0F) {
        const std::string strength = strength_text(work, vibration);
        const std::string length = parts.has_length ? length_text(own_duration_s(vibration)) : "";
        const ImVec2 size = text_size(theme.fonts.small, strength);
        const ImVec2 length_size = text_size(theme.fonts.small, length);
        const float before_px =
            parts.has_length && !parts.in_two ? length_size.x + theme.gap_px : 0.0F;
        const float middle = row.centre().y;
        const float top = parts.in_two ? middle - size.y : middle - 0.5F * size.y;
        const ImVec2 corner{edge - before_px - size.x, top};
        const bool is_marked = !mark_in_list(work.stale, vibration.name).empty();
        ImDrawList& list = *ImGui::GetWindowDrawList();
        draw_text(list, theme.fonts.small, corner, is_marked ? theme.warning : theme.text,
                  strength);
        const ImVec2 below{edge - length_size.x, parts.in_two ? middle : top};
        draw_text(list, theme.fonts.small, below, theme.dim_text, length);
        note_rect(ui.rects, "strength:" + vibration.name, corner, corner + size, strength);
    }
    const float end = parts.strength_px > 0.0F ? row.max.x - parts.strength_px : edge;
    const float begin = end - parts.thumbnail_px + 6.0F * s;
    const float pad = std::max(3.0F * s, 0.15F * row.height());
    const Rect picture{{begin, row.min.y + pad}, {end, row.max.y - pad}};
    draw_thumbnail(ui, work, picture, vibration, look.colour, shown_reach_g(work),
                   work.cache.axis_s);
    note_rect(ui.rects, "thumbnail:" + vibration.name, picture.min, picture.max);
    draw_unfelt(ui, work, vibration, picture);
    return begin;
}

void draw_row_content(Ui& ui, Workspace& work, std::size_t index, const Rect& row,
                      const RowParts& parts) {
    const Vibration& vibration = work.document.set.vibrations[index];
    const Theme& theme = ui.theme;
    const float s = theme.scale;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    draw_row_ground(ui, work, index, row);
    draw_picked_edge(ui, work, vibration, row);
    const float middle = row.centre().y;
    const float text_y = middle - ImGui::GetTextLineHeight() / 2.0F;
    const PatternLook look = look_of(ui, work, index);
    const ImVec2 mark{row.min.x + kMarkPx * s, middle};
    if (work.selection.others.contains(index)) draw_selection_ring(list, theme, mark, 5.5F * s);
    draw_pattern_mark(list, theme, mark, 5.5F * s, look, theme.pane);
    note_rect(ui.rects, "look:" + vibration.name, mark, mark,
              vibration.colour + (vibration.ring ? " ring" : ""));

    const float name_begin = row.min.x + kNamePx * s;
    const float end = draw_row_end(ui, work, vibration, look, row, parts) - 5.0F * s;
    draw_state_signs(ui, vibration, {end, middle});
    const float room = end - name_begin - state_signs_px(theme, vibration);
    const std::string shown = shortened(theme.fonts.regular, vibration.name, std::max(0.0F, room));
    draw_text(list, theme.fonts.regular, {name_begin, text_y},
              vibration.dropped ? theme.dim_text : theme.text, shown);
    if (work.selection.too_close.contains(vibration.name)) {
        list.AddCircle(mark, 9.0F * s, theme.warning, 0, 1.5F * theme.hairline_px);
    }
    const ImVec2 corner{name_begin, text_y};
    note_rect(ui.rects, "row name:" + vibration.name, corner,
              corner + text_size(theme.fonts.regular, shown), shown);
}

PatternAction draw_row(Ui& ui, Workspace& work, PatternPanes& pattern_panes, std::size_t index,
                       const RowParts& parts) {
    const float height = parts.height_px;
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    ImGui::PushID(static_cast<int>(index));
    if (pattern_panes.list.renaming == index &&
        pattern_panes.list.renaming_in == work.document_number) {
        draw_rename(ui, work, pattern_panes, index);
        ImGui::PopID();
        return PatternAction::none;
    }
    const float width = std::max(1.0F, ImGui::GetContentRegionAvail().x);
    const bool pressed = ImGui::InvisibleButton("row", {width, height});
    if (index == work.selection.current) note_stop(ui.rects.tab_order);  // applies to all of them
    if (ImGui::IsItemClicked() || (pressed && ui.keyboard_mode)) {
        pattern_panes.list.clicked = {index, ImGui::GetIO().KeyShift, ImGui::GetIO().KeyCtrl};
    }
    if (ImGui::IsItemActive()) note_pressed(work, work.document.set.vibrations[index]);
    // Over the picture only: beside it, it would cover the names.
    if (ImGui::GetIO().MousePos.x > corner.x + width - parts.strength_px - parts.thumbnail_px) {
        draw_tooltip(ui,
                     (words_on_mark(work, work.document.set.vibrations[index]) + kHoldHelp +
                      ". Drag a row to move it.\nA lighter body is modulated faster than can be "
                      "drawn here: the lighter, the weaker.")
                         .c_str());
    }
    if (ImGui::IsItemHovered()) {
        work.selection.hovered = index;
        if (ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) {
            begin_rename(work, pattern_panes, index);
        }
    }
    const Rect row = rect_at(corner, {width, height});
    note_rect(ui.rects, "row:" + work.document.set.vibrations[index].name, row.min, row.max);
    drag_row(ui, work, index, row);
    const PatternAction action = draw_row_menu(ui, work, index);
    draw_row_content(ui, work, index, row, parts);
    ImGui::PopID();
    return action;
}

void scroll_to_current(Workspace& work, const std::vector<std::size_t>& rows, float row_px) {
    if (!work.selection.scroll_to_current) return;
    work.selection.scroll_to_current = false;
    const auto place = std::ranges::find(rows, work.selection.current) - rows.begin();
    const float row_height = row_px + ImGui::GetStyle().ItemSpacing.y;
    const float target = static_cast<float>(place) * row_height;
    const float top = ImGui::GetScrollY();
    if (target < top) ImGui::SetScrollY(target);
    if (target + row_height > top + ImGui::GetWindowHeight()) {
        ImGui::SetScrollY(target + row_height - ImGui::GetWindowHeight());
    }
}

void draw_no_rows(Ui& ui, Workspace& work) {
    if (work.document.set.vibrations.empty()) {
        return draw_empty(*ImGui::GetWindowDrawList(), ui.theme, rest_of_pane(), "No patterns yet",
                          "Press New, or drop a folder of effects or recordings here.");
    }
    if (draw_empty_with(ui, rest_of_pane(), "No pattern matches the search", "",
                        {.id = "button:show all", .label = "Show all"},
                        false)) {  // New is the primary button
        work.selection.search.clear();
        work.selection.only_picked = false;
    }
}

PatternAction draw_rows(Ui& ui, Workspace& work, PatternPanes& pattern_panes) {
    PatternAction action = PatternAction::none;
    const std::vector<std::size_t> rows = listed_indices(work);
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(0.0F, 1.0F));
    if (ImGui::BeginChild("rows")) {
        const ImVec2 room{ImGui::GetContentRegionAvail().x, ImGui::GetWindowHeight()};
        const RowParts parts = row_parts(ui, work, room, rows.size());
        scroll_to_current(work, rows, parts.height_px);
        ImGuiListClipper clipper;
        clipper.Begin(static_cast<int>(rows.size()));
        while (clipper.Step()) {
            for (int k = clipper.DisplayStart; k < clipper.DisplayEnd; ++k) {
                const std::size_t row = rows[static_cast<std::size_t>(k)];
                const PatternAction asked = draw_row(ui, work, pattern_panes, row, parts);
                if (asked != PatternAction::none) action = asked;
            }
        }
        if (rows.empty()) draw_no_rows(ui, work);
    }
    ImGui::EndChild();
    ImGui::PopStyleVar();
    return action;
}

}  // namespace

void begin_rename(const Workspace& work, PatternPanes& pattern_panes, std::size_t index) {
    pattern_panes.list.renaming = index;
    pattern_panes.list.renaming_in = work.document_number;
    pattern_panes.list.rename_text = work.document.set.vibrations[index].name;
    pattern_panes.list.rename_begun = false;
}

PatternAction draw_set_panel(Ui& ui, Workspace& work, PatternPanes& pattern_panes) {
    draw_toolbar(ui, work);
    draw_effect_maps_line(ui, work);
    return draw_rows(ui, work, pattern_panes);
}

}  // namespace tact
