#include <imgui.h>

#include <algorithm>
#include <string>
#include <vector>

#include "app/library/library.h"
#include "app/library/parts.h"
#include "app/ui/widgets.h"
#include "model/text/numbers.h"
#include "model/text/shown_text.h"
#include "viz/drawing/marks.h"
#include "viz/drawing/plot.h"

namespace tact {

namespace {

constexpr float kRowPx = 24.0F;
constexpr float kLeastNamePx = 90.0F;

// Bars from the middle line, as thumbnails of waveforms are drawn.
void draw_shape(const Theme& theme, const Rect& area, const StrengthShape& shape, ImU32 colour) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float each = area.width() / static_cast<float>(kShapeParts);
    const float middle = area.centre().y;
    for (std::size_t k = 0; k < kShapeParts; ++k) {
        const float half = 0.5F * area.height() * static_cast<float>(shape[k]);
        const float left = area.min.x + each * static_cast<float>(k);
        const float least = 0.5F * theme.hairline_px;
        list.AddRectFilled({left, middle - std::max(half, least)},
                           {left + each, middle + std::max(half, least)}, colour);
    }
}

struct Column {
    LibraryColumn which;
    const char* id;
    const char* words;
    const char* help;
    float begin_px = 0.0F;
    float end_px = 0.0F;
};

// From the right, as wide as their numbers; what is left is the name's.
std::vector<Column> columns_in(float width_px, float s, bool has_match, bool is_pm) {
    std::vector<Column> columns{
        {LibraryColumn::file, "file", "", "As the files are ordered."},
        {LibraryColumn::name, "name", "name", "Sort by it; again: the other way round."},
        {LibraryColumn::duration, "duration", "s", "Length."},
        {LibraryColumn::peak, "peak", "g", "Peak, as the file's actuator map has it."},
        {LibraryColumn::frequency, "frequency", "Hz", "Mean frequency by power."},
        {LibraryColumn::ticks, "ticks", "ticks", "Transients."}};
    if (has_match) {
        columns.push_back({LibraryColumn::match, "match", is_pm ? "PM" : "off",
                           is_pm ? "PM of the ranks among these comparisons: it says which is "
                                   "nearer, not by how much."
                                 : "How far the strength is off the drawn shape, on average: 0 to "
                                   "1."});
    }
    const float picture = std::min(84.0F * s, 0.2F * width_px);
    const float number = 50.0F * s;
    const bool is_narrow =
        width_px - picture - number * static_cast<float>(columns.size() - 2) < kLeastNamePx * s;
    if (is_narrow)
        std::erase_if(columns, [](const Column& one) {
            return one.which == LibraryColumn::frequency || one.which == LibraryColumn::ticks;
        });
    float end = width_px;
    for (std::size_t k = columns.size(); k-- > 2;) {
        columns[k].end_px = end;
        end -= number;
        columns[k].begin_px = end;
    }
    columns[0].end_px = picture;
    columns[1].begin_px = picture;
    columns[1].end_px = end;
    return columns;
}

void draw_heads(Ui& ui, LibraryState& state, const std::vector<Column>& columns) {
    const Theme& theme = ui.theme;
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const float height = 20.0F * theme.scale;
    for (const Column& column : columns) {
        const Rect cell{{corner.x + column.begin_px, corner.y},
                        {corner.x + column.end_px, corner.y + height}};
        ImGui::SetCursorScreenPos(cell.min);
        const std::string id = std::string("by ") + column.id;
        if (ImGui::InvisibleButton(id.c_str(), cell.size())) sort_library(state, column.which);
        const bool is_sorted = state.by == column.which;
        say_of_last_item(ui, {.id = "library:" + id,
                              .text = !is_sorted         ? ""
                                      : state.descending ? "down"
                                                         : "up",
                              .tip = column.help});
        std::string words = column.which == LibraryColumn::file ? "shape" : column.words;
        if (is_sorted) words += state.descending ? " \u2193" : " \u2191";
        const ImVec2 size = text_size(theme.fonts.small, words);
        const bool is_left =
            column.which == LibraryColumn::name || column.which == LibraryColumn::file;
        const float pad = 4.0F * theme.scale;
        draw_text(*ImGui::GetWindowDrawList(), theme.fonts.small,
                  {is_left ? cell.min.x + pad : cell.max.x - pad - size.x,
                   cell.centre().y - size.y / 2.0F},
                  is_sorted || ImGui::IsItemHovered() ? theme.text : theme.dim_text, words);
    }
    ImGui::SetCursorScreenPos({corner.x, corner.y + height});
}

std::string cell_words(const LibraryEntry& entry, const LibraryRow& row, LibraryColumn column,
                       bool is_pm) {
    switch (column) {
        case LibraryColumn::duration:
            return significant_digits(entry.duration_s, 3);
        case LibraryColumn::peak:
            return significant_digits(entry.peak_g, 3);
        case LibraryColumn::frequency:
            return entry.mean_hz ? significant_digits(*entry.mean_hz, 3) : "-";
        case LibraryColumn::ticks:
            return entry.ticks > 0 ? std::to_string(entry.ticks) : "";
        case LibraryColumn::match:
            if (!row.match) return "";
            return is_pm ? significant_digits(*row.match, 4) : significant(*row.match, 2);
        default:
            return entry.name;
    }
}

std::string row_help(const Library& library, const LibraryEntry& entry) {
    const LibraryFile& file = file_of(library, entry);
    std::string words = shown_text(entry.name) + "\n" + shown_text(file.path);
    if (!entry.note.empty()) words += "\n" + shown_text(entry.note);
    if (entry.synthetic) words += "\nSYNTHETIC: computed, not recorded.";
    if (!file.licence.empty()) words += "\nLicence: " + shown_text(file.licence);
    return words + "\nHold to feel it, double-click or drag it out to add it.";
}

void choose(LibraryState& state, std::size_t place) {
    const std::size_t entry = state.rows[place].entry;
    const ImGuiIO& io = ImGui::GetIO();
    if (io.KeyCtrl) {
        if (state.chosen.erase(entry) == 0) state.chosen.insert(entry);
    } else if (io.KeyShift) {
        const auto last = std::ranges::find(state.rows, state.last_chosen, &LibraryRow::entry);
        auto from =
            last == state.rows.end() ? place : static_cast<std::size_t>(last - state.rows.begin());
        auto to = place;
        if (to < from) std::swap(from, to);
        for (std::size_t k = from; k <= to; ++k) state.chosen.insert(state.rows[k].entry);
        return;
    } else {
        state.chosen = {entry};
    }
    state.last_chosen = entry;
}

// In the order of the list.
std::vector<std::size_t> chosen_entries(const LibraryState& state) {
    std::vector<std::size_t> entries;
    if (state.chosen.empty()) return entries;
    for (const LibraryRow& row : state.rows) {
        if (state.chosen.contains(row.entry)) entries.push_back(row.entry);
    }
    return entries;
}

void draw_row(Ui& ui, Workspace& work, LibraryState& state, std::size_t place,
              const std::vector<Column>& columns) {
    const Theme& theme = ui.theme;
    const float s = theme.scale;
    const LibraryRow& row = state.rows[place];
    const LibraryEntry& entry = state.library->entries[row.entry];
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const Rect line = rect_at(corner, {columns[columns.size() - 1].end_px, kRowPx * s});
    ImGui::PushID(static_cast<int>(row.entry));
    ImGui::InvisibleButton("row", line.size());
    const bool is_hovered = ImGui::IsItemHovered();
    if (ImGui::IsItemActivated() && !state.chosen.contains(row.entry)) choose(state, place);
    if (ImGui::IsItemActive()) {
        hold_entry(ui, work, state, row.entry);
        if (ImGui::IsMouseDragging(ImGuiMouseButton_Left)) state.is_dragging = true;
    }
    // A click on one of several leaves that one chosen, a drag takes all of them.
    if (ImGui::IsItemDeactivated() && !state.is_dragging) choose(state, place);
    if (is_hovered && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left))
        add_entries(ui, work, state, {row.entry});
    note_item(ui.rects, "library row:" + entry.name,
              state.chosen.contains(row.entry) ? "chosen" : "");
    if (is_hovered && !state.is_dragging) draw_tooltip(ui, row_help(*state.library, entry).c_str());
    ImGui::PopID();
    ImDrawList& list = *ImGui::GetWindowDrawList();
    if (state.chosen.contains(row.entry)) {
        list.AddRectFilled(line.min, line.max, theme.field, theme.rounding_px);
        draw_selection_frame(list, theme, line);
    } else if (is_hovered) {
        list.AddRectFilled(line.min, line.max, theme.hover, theme.rounding_px);
    }
    for (const Column& column : columns) {
        const Rect cell{{line.min.x + column.begin_px + 4.0F * s, line.min.y + 3.0F * s},
                        {line.min.x + column.end_px - 4.0F * s, line.max.y - 3.0F * s}};
        if (column.which == LibraryColumn::file) {
            draw_shape(theme, cell, entry.shape, theme.series);
            continue;
        }
        const bool is_name = column.which == LibraryColumn::name;
        std::string words = shown_text(cell_words(entry, row, column.which, bool(state.alike)));
        if (is_name && entry.synthetic) words += " (synthetic)";
        if (is_name && !row.is_felt) words += " (not felt)";
        words = shortened(theme.fonts.regular, words, cell.width());
        const ImVec2 size = text_size(theme.fonts.regular, words);
        draw_text(list, theme.fonts.regular,
                  {is_name ? cell.min.x : cell.max.x - size.x, cell.centre().y - size.y / 2.0F},
                  theme.text, words);
    }
}

// Dropped anywhere outside of the pane, what is chosen is added.
void follow_drag(Ui& ui, const Workspace& work, LibraryState& state, const Rect& pane) {
    if (!state.is_dragging) return;
    const std::vector<std::size_t> entries = chosen_entries(state);
    const bool is_outside = !pane.contains(ImGui::GetIO().MousePos);
    if (ImGui::IsMouseDown(ImGuiMouseButton_Left)) {
        const std::string words = is_outside
                                      ? "Add " + counted(entries.size(), "pattern", "patterns")
                                      : "Drag it to the patterns or the map";
        ImGui::SetTooltip("%s", words.c_str());
        return;
    }
    state.is_dragging = false;
    if (is_outside) add_entries(ui, work, state, entries);
}

void draw_foot(Ui& ui, const Workspace& work, LibraryState& state) {
    const std::vector<std::size_t> entries = chosen_entries(state);
    const std::string add =
        entries.size() < 2 ? "Add to the set" : "Add " + grouped_digits(entries.size());
    if (primary_button(ui, {.id = "library:add", .label = add, .enabled = !entries.empty()}))
        add_entries(ui, work, state, entries);
    flow_on(button_width("More like it"), ui.theme.gap_px);
    if (button(ui, {.id = "library:more like it",
                    .label = "More like it",
                    .tip = "Entries that feel most like the chosen one come first, by PM.",
                    .enabled = entries.size() == 1})) {
        state.drawn.clear();
        find_alike_entry(ui, work, state, entries.front());
    }
    const std::string told = grouped_digits(state.rows.size()) + " of " +
                             grouped_digits(state.library->entries.size()) + ", " +
                             grouped_digits(entries.size()) + " chosen";
    dim_text_beside(ui, {.id = "library:count", .text = told});
}

}  // namespace

void draw_library_list(Ui& ui, Workspace& work, LibraryState& state) {
    const std::vector<LibraryRow>& rows = library_rows(state);
    const bool has_match = state.alike || !state.drawn.empty();
    const std::vector<Column> columns =
        columns_in(ImGui::GetContentRegionAvail().x - ImGui::GetStyle().ScrollbarSize,
                   ui.theme.scale, has_match, bool(state.alike));
    draw_heads(ui, state, columns);
    const float foot_px = ui.as_picture ? 0.0F : ImGui::GetFrameHeightWithSpacing();
    const Rect pane = rest_of_pane();
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(0.0F, 0.0F));
    if (ImGui::BeginChild("library", {0.0F, std::max(1.0F, pane.height() - foot_px)})) {
        ImGuiListClipper clipper;
        clipper.Begin(static_cast<int>(rows.size()), kRowPx * ui.theme.scale);
        while (clipper.Step()) {
            for (int k = clipper.DisplayStart; k < clipper.DisplayEnd; ++k)
                draw_row(ui, work, state, static_cast<std::size_t>(k), columns);
        }
        if (rows.empty()) {
            draw_empty(*ImGui::GetWindowDrawList(), ui.theme, rest_of_pane(),
                       state.library->entries.empty() ? "Nothing in this folder can be read"
                                                      : "No entry has these words",
                       state.library->entries.empty()
                           ? "Effects, recordings and sets are looked for in all its folders."
                           : "Each word has to be in its name, description, path or licence.");
        }
    }
    ImGui::EndChild();
    ImGui::PopStyleVar();
    follow_drag(ui, work, state, pane);
    if (!ui.as_picture) draw_foot(ui, work, state);
}

}  // namespace tact
