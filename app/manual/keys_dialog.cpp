#include "app/manual/manual.h"

#include <imgui_internal.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <numeric>
#include <vector>

#include "app/ui/ui.h"
#include "app/ui/widgets.h"
#include "model/text/utf8.h"
#include "viz/drawing/imgui_versions.h"
#include "viz/drawing/marks.h"

namespace tact {

namespace {

constexpr float kColumnPx = 350.0F;  // at the least
constexpr float kDialogPx = 1280.0F;
constexpr float kKeysShare = 0.42F;  // of a column
constexpr std::size_t kMostColumns = 3;

// A line of a column: the head of a group, or keys and what they do, in lines as they fit.
struct Block {
    std::string head;  // of a group; empty: a row
    std::vector<std::string> keys{};
    std::vector<std::string> what{};
    float height_px = 0.0F;
};

bool matches(const KeyRow& row, const std::string& wanted) {
    const std::string all = lower_case(row.group + " " + row.keys + " " + row.what);
    return all.find(wanted) != std::string::npos;
}

// Below its group a command needs no menu.
std::string words_of(const KeyRow& row) {
    const std::string menu = row.group + " > ";
    return row.what.starts_with(menu) ? row.what.substr(menu.size()) : row.what;
}

std::vector<Block> blocks_of(const Ui& ui, std::span<const KeyRow> rows, const std::string& wanted,
                             float width_px) {
    const Theme& theme = ui.theme;
    const float line = text_size(theme.fonts.small, "X").y;
    const float keys_px = kKeysShare * width_px - theme.gap_px;
    std::vector<Block> blocks;
    std::string group;
    for (const KeyRow& row : rows) {
        if (!matches(row, wanted)) continue;
        if (row.group != group) {
            const float above = blocks.empty() ? 0.0F : theme.gap_px;
            group = row.group;
            blocks.push_back({group, {}, {}, above + text_size(theme.fonts.semibold, group).y});
        }
        Block block;
        block.keys = wrapped(theme.fonts.small, row.keys, keys_px);
        block.what = wrapped(theme.fonts.small, words_of(row), (1.0F - kKeysShare) * width_px);
        const auto lines = static_cast<float>(std::max(block.keys.size(), block.what.size()));
        block.height_px = lines * line + 1.5F * theme.scale;
        blocks.push_back(std::move(block));
    }
    return blocks;
}

// Where each column begins, of about equal height; none ends with a head.
std::vector<std::size_t> column_starts(const std::vector<Block>& blocks, std::size_t columns) {
    const float all =
        std::accumulate(blocks.begin(), blocks.end(), 0.0F,
                        [](float sum, const Block& block) { return sum + block.height_px; });
    std::vector<std::size_t> starts{0};
    float height = 0.0F;
    for (std::size_t k = 0; k < blocks.size(); ++k) {
        const float end = all * static_cast<float>(starts.size()) / static_cast<float>(columns);
        if (starts.size() < columns && height + 0.5F * blocks[k].height_px > end) {
            const bool after_head = k > 0 && !blocks[k - 1].head.empty();
            starts.push_back(after_head ? k - 1 : k);
        }
        height += blocks[k].height_px;
    }
    starts.push_back(blocks.size());
    return starts;
}

float draw_lines(const ImFont* font, ImVec2 corner, ImU32 ink,
                 const std::vector<std::string>& lines) {
    for (const std::string& line : lines) {
        draw_text(*ImGui::GetWindowDrawList(), font, corner, ink, line);
        corner.y += text_size(font, line).y;
    }
    return corner.y;
}

// Begins with the head of its first block; a group that continues says its name again.
float draw_column(Ui& ui, std::span<const Block> blocks, ImVec2 corner, float width_px,
                  const std::string& group) {
    const Theme& theme = ui.theme;
    float y = corner.y;
    if (!blocks.empty() && blocks.front().head.empty()) {
        const std::string again = group + ", continued";
        draw_text(*ImGui::GetWindowDrawList(), theme.fonts.semibold, {corner.x, y}, theme.dim_text,
                  again);
        y += text_size(theme.fonts.semibold, again).y;
    }
    for (const Block& block : blocks) {
        if (!block.head.empty()) {
            y += y > corner.y ? theme.gap_px : 0.0F;
            draw_text(*ImGui::GetWindowDrawList(), theme.fonts.semibold, {corner.x, y}, theme.text,
                      block.head);
            note_rect(ui.rects, "keys:" + block.head, {corner.x, y},
                      ImVec2{corner.x, y} + text_size(theme.fonts.semibold, block.head));
            y += text_size(theme.fonts.semibold, block.head).y;
            continue;
        }
        draw_lines(theme.fonts.small, {corner.x, y}, theme.text, block.keys);
        draw_lines(theme.fonts.small, {corner.x + kKeysShare * width_px, y}, theme.dim_text,
                   block.what);
        y += block.height_px;
    }
    return y - corner.y;
}

void draw_columns(Ui& ui, std::span<const KeyRow> rows, const std::string& wanted) {
    const Theme& theme = ui.theme;
    const float room = ImGui::GetContentRegionAvail().x;
    const float gap = 2.0F * theme.padding_px;
    const auto count = static_cast<std::size_t>(std::clamp(
        (room + gap) / (kColumnPx * theme.scale + gap), 1.0F, static_cast<float>(kMostColumns)));
    const float width = (room + gap) / static_cast<float>(count) - gap;
    const std::vector<Block> blocks = blocks_of(ui, rows, wanted, width);
    if (blocks.empty()) return dim_text(ui, "No key and no gesture has this in its words.");
    const std::vector<std::size_t> starts = column_starts(blocks, count);
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    float height = 0.0F;
    std::string group;
    for (std::size_t k = 0; k + 1 < starts.size(); ++k) {
        const auto column = std::span(blocks).subspan(starts[k], starts[k + 1] - starts[k]);
        const ImVec2 top{corner.x + static_cast<float>(k) * (width + gap), corner.y};
        height = std::max(height, draw_column(ui, column, top, width, group));
        for (const Block& block : column) {
            if (!block.head.empty()) group = block.head;
        }
    }
    ImGui::Dummy({room, height});
}

// Words to look for, and the manual; F1 has opened the list in this very frame, or opens that.
// True: it was.
bool draw_head(Ui& ui, ManualState& manual) {
    constexpr const char* kManual = "Open the manual";
    const bool appears = ImGui::IsWindowAppearing();
    if (appears) {
        manual.wanted_keys.clear();
        focus_next_item();
    }
    ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x - button_width(kManual) -
                            ui.theme.gap_px);
    ImGui::InputTextWithHint("##wanted", "Search keys and gestures", &manual.wanted_keys);
    note_item(ui.rects, "keys:search", manual.wanted_keys);
    ImGui::SameLine(0.0F, ui.theme.gap_px);
    const auto pressed = [](ImGuiKey which) { return ImGui::IsKeyPressed(which, false); };
    const bool enter =
        pressed(ImGuiKey_Enter) && manual.wanted_keys.empty() && !ui.rects.tab_order.is_on_button;
    const Item item{.id = "button:manual",
                    .label = kManual,
                    .tip = "Every pane, format and limit, in the browser (F1 again, or Enter)"};
    return button(ui, item) || (!appears && (pressed(ImGuiKey_F1) || enter));
}

}  // namespace

void draw_keys_dialog(Ui& ui, ManualState& manual, std::span<const KeyRow> rows) {
    if (!begin_dialog(ui, kKeysDialog, kDialogPx)) return;
    if (draw_head(ui, manual)) {
        open_manual(ui, manual);
        ui.dialog = kNoDialog;
        ImGui::CloseCurrentPopup();
    }
    ImGui::Spacing();
    // The head stays where it is.
    const float most = dialog_room_px() - ImGui::GetCursorPosY() - 4.0F * ui.theme.scale;
    const float height =
        manual.keys_height_px > 0.0F ? std::min(manual.keys_height_px, most) : most;
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0.0F, 0.0F));
    ImGui::BeginChild("keys", {0.0F, height});
    draw_columns(ui, rows, lower_case(manual.wanted_keys));
    if (manual.wanted_keys.empty()) {
        manual.keys_height_px = ImGui::GetCursorPosY() + ImGui::GetScrollY();
    }
    ImGui::EndChild();
    ImGui::PopStyleVar();
    end_dialog(ui);
}

}  // namespace tact
