// The dialog on a table: its first rows, a choice above each column, what will come of it.
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "app/progress/progress.h"
#include "app/tables/tables.h"
#include "app/ui/ui.h"
#include "app/ui/widgets.h"
#include "viz/drawing/colour.h"
#include "viz/drawing/marks.h"

namespace tact {

namespace {

constexpr float kTableDialogPx = 900.0F;
constexpr float kColumnPx = 120.0F;
constexpr std::size_t kMostColumns = 60;  // ImGui's tables have at most 64
constexpr const char* kNotRead = "not read";

// A row of switches of which one is on; true when another was chosen.
template <class Value, std::size_t kCount>
bool draw_choice(Ui& ui, const char* label, const std::pair<const char*, Value> (&choices)[kCount],
                 Value& value) {
    bool changed = false;
    draw_label(ui, label);
    for (const auto& [text, one] : choices) {
        if (&one != &choices[0].second) flow_on(chip_width(ui, text), 2.0F * ui.theme.scale);
        const bool is_on = value == one;
        const Item item{.id = std::string("table:") + label + " " + text,
                        .label = text,
                        .value = is_on ? "chosen" : ""};
        if (!toggle(ui, item, is_on) || is_on) continue;
        value = one;
        changed = true;
    }
    return changed;
}

bool draw_how_it_is_written(Ui& ui, TableWords& words) {
    using Sign = std::optional<char>;
    bool changed = draw_choice<Sign>(
        ui, "Between cells",
        {{"as found", {}}, {"commas", ','}, {"semicolons", ';'}, {"tabs", '\t'}, {"blanks", ' '}},
        words.written.separator);
    changed |= draw_choice<Sign>(ui, "Decimals", {{"as found", {}}, {"0.5", '.'}, {"0,5", ','}},
                                 words.written.decimal);
    return changed;
}

bool draw_of_its_kind(Ui& ui, TableWords& words) {
    if (words.kind == TableKind::ratings) {
        return draw_choice<RatingScale>(ui, "A high rating is",
                                        {{"guessed", RatingScale::guess},
                                         {"unlike", RatingScale::dissimilarity},
                                         {"alike", RatingScale::similarity}},
                                        words.scale);
    }
    bool changed = draw_choice<std::optional<TimeUnit>>(ui, "Times in",
                                                        {{"as named", {}},
                                                         {"s", TimeUnit::s},
                                                         {"ms", TimeUnit::ms},
                                                         {"us", TimeUnit::us},
                                                         {"ns", TimeUnit::ns}},
                                                        words.time_unit);
    changed |=
        draw_choice<std::optional<AccelerationUnit>>(ui, "Values in",
                                                     {{"as named", {}},
                                                      {"g", AccelerationUnit::g},
                                                      {"m/s\u00b2", AccelerationUnit::m_per_s2},
                                                      {"V", AccelerationUnit::volt}},
                                                     words.unit);
    return changed;
}

// What a column is read as; true when another use was chosen.
bool draw_use(Ui& ui, const TableAnswer& answer, std::size_t column, std::string& chosen) {
    const std::string& now = answer.uses[column];
    ImGui::PushID(static_cast<int>(column));
    bool changed = false;
    const auto offer = [&](const char* text, const std::string& use) {
        const Item item{.id = std::string("table:offer ") + text, .label = text};
        if (!option(ui, item, use == now) || use == now) return;
        chosen = use;
        changed = true;
    };
    const Item shown{.id = "table:use " + std::to_string(column + 1),
                     .label = now.empty() ? kNotRead : now,
                     .value = now};
    ImGui::PushStyleColor(ImGuiCol_Text, now.empty() ? ui.theme.dim_text : ui.theme.text);
    drop_down(
        ui, shown, -1.0F,
        [&] {
            ImGui::PushStyleColor(ImGuiCol_Text, ui.theme.text);
            offer(kNotRead, "");
            for (const char* use : table_uses(answer.request.words.kind)) offer(use, use);
            ImGui::PopStyleColor();
        },
        ImGuiComboFlags_HeightRegular);
    ImGui::PopStyleColor();
    ImGui::PopID();
    return changed;
}

// True when the use of a column was changed.
bool draw_rows(Ui& ui, const TableAnswer& answer, TableWords& words) {
    const std::size_t columns = std::min(answer.uses.size(), kMostColumns);
    if (columns == 0) return false;
    const float height =
        ImGui::GetTextLineHeightWithSpacing() * static_cast<float>(answer.head.rows.size() + 1) +
        2.0F * ImGui::GetFrameHeightWithSpacing();
    constexpr ImGuiTableFlags kFlags = ImGuiTableFlags_ScrollX | ImGuiTableFlags_ScrollY |
                                       ImGuiTableFlags_BordersInnerV |
                                       ImGuiTableFlags_SizingFixedFit;
    const float room = ImGui::GetIO().DisplaySize.y * 0.4F;
    // A table keeps the widths that it began with: another room, another table.
    const float even = ImGui::GetContentRegionAvail().x / static_cast<float>(columns);
    const std::string id = "rows " + std::to_string(std::lround(even));
    if (!ImGui::BeginTable(id.c_str(), static_cast<int>(columns), kFlags,
                           {0.0F, std::min(height, room)})) {
        return false;
    }
    const float least = kColumnPx * ui.theme.scale;
    for (std::size_t k = 0; k < columns; ++k) {
        ImGui::TableSetupColumn("", ImGuiTableColumnFlags_WidthFixed,
                                std::max(least, even - 2.0F * ImGui::GetStyle().CellPadding.x));
    }
    ImGui::TableSetupScrollFreeze(0, 1);
    ImGui::TableNextRow();
    bool changed = false;
    for (std::size_t k = 0; k < columns; ++k) {
        ImGui::TableNextColumn();
        std::string use;
        if (!draw_use(ui, answer, k, use)) continue;
        use_column(words, answer, k, use);
        changed = true;
    }
    for (std::size_t row = 0; row < answer.head.rows.size(); ++row) {
        ImGui::TableNextRow();
        for (std::size_t k = 0; k < columns; ++k) {
            ImGui::TableNextColumn();
            const auto& cells = answer.head.rows[row];
            if (k >= cells.size()) continue;
            const bool is_name = row == 0;
            const bool is_read = !answer.uses[k].empty();
            ImGui::PushStyleColor(ImGuiCol_Text,
                                  is_name || is_read ? ui.theme.text : ui.theme.dim_text);
            ImGui::TextUnformatted(label_of(cells[k]).c_str());
            ImGui::PopStyleColor();
        }
    }
    ImGui::EndTable();
    return changed;
}

void draw_outcome(Ui& ui, const TableState& table, bool is_newest) {
    const TableAnswer* answer = table.answer.get();
    if (answer == nullptr || !is_newest) {
        if (!draw_failure(ui, "table", table.job.failure())) dim_text(ui, "Reading\u2026");
        return;
    }
    const bool is_bad = !answer->fault.empty();
    const std::string text = is_bad ? answer->fault : answer->outcome + ".";
    if (is_bad) ImGui::PushStyleColor(ImGuiCol_Text, ui.theme.warning);
    wrapped_text(ui, {.id = "table:outcome", .text = text});
    if (is_bad) ImGui::PopStyleColor();
    for (const std::string& remark : answer->remarks) wrapped_text(remark + ".");
}

}  // namespace

void draw_table_dialog(Ui& ui, Workspace& work, Layout& layout, TableState& table,
                       ImportState& importing) {
    if (!begin_dialog(ui, kTableDialog, kTableDialogPx)) return;
    const bool is_newest = table.answer && table.answer->request.words == table.words;
    coloured_text(ui.theme.dim_text,
                  label_of(table.file.filename().string()) +
                      ": what is in each column? It is remembered for tables with the same names.");
    TableWords words = table.words;
    draw_choice<TableKind>(ui, "It holds",
                           {{"ratings", TableKind::ratings}, {"a recording", TableKind::recording}},
                           words.kind);
    if (table.answer) draw_rows(ui, *table.answer, words);
    draw_of_its_kind(ui, words);
    draw_how_it_is_written(ui, words);
    ImGui::Spacing();
    draw_outcome(ui, table, is_newest);
    if (words != table.words) {
        table.words = words;
        look_at_table(ui, work, table);
    }
    const bool is_recording = table.words.kind == TableKind::recording;
    const auto is_used = [](const std::string& use) { return !use.empty(); };
    // What a recording lacks, the dialog that follows asks.
    const bool is_ready =
        is_newest && (table.answer->fault.empty() ||
                      (is_recording && std::ranges::any_of(table.answer->uses, is_used)));
    if (draw_ends(ui, is_recording ? "Import..." : "Load ratings", is_ready)) {
        take_table(ui, work, layout, table, importing);
    }
}

}  // namespace tact
