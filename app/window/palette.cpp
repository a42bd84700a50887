// The command palette: every command by a few letters of its name.

#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>

#include "app/ui/widgets.h"
#include "app/window/commands.h"
#include "app/window/dialogs.h"
#include "viz/drawing/marks.h"

namespace tact {

namespace {

std::vector<const Command*> palette_matches(const App& app) {
    std::vector<const Command*> found;
    const std::string wanted = lower_case(app.palette.text);
    for (const Command& command : commands()) {
        if (*command.menu == '\0' || !command.enabled(app)) continue;
        const std::string all =
            lower_case(std::string(command.menu) + " " + command.name + " " + command.words);
        if (all.find(wanted) != std::string::npos) found.push_back(&command);
    }
    return found;
}

// As in a menu: the name, its menu dim after it, the shortcut at the right end.
bool draw_palette_row(App& app, const Command& command, bool lit) {
    const Theme& theme = app.ui.theme;
    const std::string name = item_text(app, command);
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const float width = ImGui::GetContentRegionAvail().x;
    ImGui::PushID(&command);
    const bool pressed = ImGui::Selectable("##row", lit);
    ImGui::PopID();
    note_item(app.ui.rects, std::string("palette:") + command.name,
              shortcut_text(command.shortcut));
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const std::string keys = shortcut_text(command.shortcut);
    const float keys_px = text_size(theme.fonts.regular, keys).x;
    draw_text(list, theme.fonts.regular, {corner.x + width - keys_px, corner.y}, theme.dim_text,
              keys);
    const float room = width - (keys.empty() ? 0.0F : keys_px + 2.0F * theme.gap_px);
    const std::string shown = shortened(theme.fonts.regular, name, room);
    draw_text(list, theme.fonts.regular, corner, theme.text, shown);
    const float used = text_size(theme.fonts.regular, shown).x + theme.gap_px;
    if (used + text_size(theme.fonts.small, command.menu).x > room) return pressed;
    draw_text(list, theme.fonts.small, {corner.x + used, corner.y + 2.0F * theme.scale},
              theme.dim_text, command.menu);
    return pressed;
}

}  // namespace

void draw_palette(App& app, std::span<const KeyPress> pressed) {
    PaletteState& state = app.palette;
    if (app.ui.question) state.open = false;
    if (!state.open) return;
    const ImVec2 screen = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos({screen.x / 2.0F, screen.y * 0.18F}, ImGuiCond_Always, {0.5F, 0.0F});
    ImGui::SetNextWindowSize({std::min(560.0F * app.ui.theme.scale, screen.x * 0.9F), 0.0F});
    ImGui::SetNextWindowFocus();
    ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, app.ui.theme.hairline_px);
    ImGui::PushStyleColor(ImGuiCol_WindowBg, ImGui::GetStyleColorVec4(ImGuiCol_PopupBg));
    ImGui::PushStyleColor(ImGuiCol_FrameBg, dialog_field(app.ui.theme));
    if (ImGui::Begin("Command palette", &state.open,
                     ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoSavedSettings |
                         ImGuiWindowFlags_NoNav)) {
        ImGui::SetNextItemWidth(-1.0F);
        if (ImGui::IsWindowAppearing()) ImGui::SetKeyboardFocusHere();
        if (ImGui::InputTextWithHint("##what", "What would you like to do?", &state.text)) {
            state.choice = 0;
        }
        const std::vector<const Command*> found = palette_matches(app);
        const int last = static_cast<int>(found.size()) - 1;
        if (was_pressed(pressed, key::kDown)) ++state.choice;
        if (was_pressed(pressed, key::kUp)) --state.choice;
        state.choice = std::clamp(state.choice, 0, std::max(0, last));
        const Command* chosen = nullptr;
        const float row_px = ImGui::GetTextLineHeightWithSpacing();
        const int shown = std::clamp(static_cast<int>((screen.y * 0.72F) / row_px) - 2, 3, 12);
        const int first = std::max(0, state.choice - shown + 1);
        for (int k = first; k <= last && k < first + shown; ++k) {
            const Command& command = *found[static_cast<std::size_t>(k)];
            if (draw_palette_row(app, command, k == state.choice)) chosen = &command;
        }
        if (found.empty()) dim_text(app.ui, "No command has this in its name.");
        if (was_pressed(pressed, key::kEnter) && !found.empty()) {
            chosen = found[static_cast<std::size_t>(state.choice)];
        }
        if (was_pressed(pressed, key::kEscape)) state.open = false;
        if (chosen != nullptr) {
            state.open = false;
            carry_out(app, *chosen);
        }
    }
    ImGui::End();
    ImGui::PopStyleColor(2);
    ImGui::PopStyleVar();
}

}  // namespace tact
