// Commands from the keyboard: the command of each key, unless the key is for a text field or a
// dialog; and the palette, which finds every command by a few letters of its name.

#include <imgui_internal.h>
#include <imgui_stdlib.h>

#include <algorithm>

#include "app/ui/ui.h"
#include "app/ui/widgets.h"
#include "app/window/window.h"
#include "model/text/utf8.h"
#include "viz/drawing/imgui_versions.h"
#include "viz/drawing/marks.h"

namespace tact {

namespace {

bool matches(const Shortcut& shortcut, const KeyPress& press) {
    if (shortcut.ctrl != press.ctrl || press.alt || press.super) return false;
    if (shortcut.code != key::kUnknown) {
        return shortcut.code == press.code && shortcut.shift == press.shift;
    }
    if (shortcut.sign == 0 || shortcut.sign != press.sign) return false;
    // On many layouts + needs Shift: for signs that are not letters, Shift is ignored.
    const bool letter = shortcut.sign >= 'a' && shortcut.sign <= 'z';
    return !letter || shortcut.shift == press.shift;
}

// Ctrl+Z, C, V, A, Y and the keys that move in text belong to a text field while it is active.
bool belongs_to_text(const Shortcut& shortcut) {
    if (!shortcut.ctrl) return shortcut.code < key::kF1 || shortcut.sign != 0;
    constexpr std::u32string_view kText = U"zycvxa";
    return kText.find(shortcut.sign) != std::u32string_view::npos;
}

// ImGui wants text for one frame longer than a field is active: the first key after Enter is no
// longer the field's.
bool is_text_active() { return ImGui::GetIO().WantTextInput && ImGui::IsAnyItemActive(); }

// A digit typed at a locked field, or while its slider is held, was meant as a number.
bool is_meant_for_field(const App& app, const Shortcut& shortcut) {
    const bool is_digit = !shortcut.ctrl && shortcut.sign >= '0' && shortcut.sign <= '9';
    return is_digit && (!app.ui.field.locked.empty() || ImGui::IsAnyItemActive());
}

// Whether it changes the document, or the part of it that is edited.
bool touches_document(const Command& command) {
    const std::string_view menu = command.menu;
    if (menu.empty()) return command.shortcut.code != key::kEscape;
    return menu == "File" || menu == "Edit";
}

// A running drag or entry ends first, on the pattern it began with: it gets its value and its undo
// step while the panels are drawn, and the command follows in the same frame.
void run(App& app, const Command& command) {
    if (!ImGui::IsAnyItemActive() || !touches_document(command)) return carry_out(app, command);
    ImGui::ClearActiveID();
    app.ui.waiting.emplace_back([&app, &command] { carry_out(app, command); });
}

std::vector<const Command*> palette_matches(const App& app) {
    std::vector<const Command*> found;
    const std::string wanted = lower_case(app.palette.text);
    for (const Command& command : commands()) {
        if (*command.menu == '\0') continue;
        const std::string all =
            lower_case(std::string(command.menu) + " " + command.name + " " + command.words);
        if (all.find(wanted) != std::string::npos) found.push_back(&command);
    }
    // Enabled commands come first, the rest tell why they are disabled; in both, those with a
    // matching name come first.
    std::ranges::stable_sort(found, {}, [&](const Command* one) {
        return std::pair(!one->enabled(app),
                         lower_case(one->name).find(wanted) == std::string::npos);
    });
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
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const char* lack = what_lacks(app, command);
    const std::string keys = lack == nullptr ? shortcut_text(command.shortcut) : lack;
    const float keys_px = text_size(theme.fonts.regular, keys).x;
    draw_text(list, theme.fonts.regular, {corner.x + width - keys_px, corner.y}, theme.dim_text,
              keys);
    note_item(app.ui.rects, std::string("palette:") + command.name, keys);
    const float room = width - (keys.empty() ? 0.0F : keys_px + 2.0F * theme.gap_px);
    const std::string shown = shortened(theme.fonts.regular, name, room);
    draw_text(list, theme.fonts.regular, corner, lack == nullptr ? theme.text : theme.dim_text,
              shown);
    const float used = text_size(theme.fonts.regular, shown).x + theme.gap_px;
    if (used + text_size(theme.fonts.small, command.menu).x > room) return pressed;
    draw_text(list, theme.fonts.small, {corner.x + used, corner.y + 2.0F * theme.scale},
              theme.dim_text, command.menu);
    return pressed;
}

}  // namespace

std::string shortcut_text(const Shortcut& shortcut) {
    std::string text;
    if (shortcut.ctrl) text += "Ctrl+";
    if (shortcut.shift) text += "Shift+";
    // The dim colour of menus would hardly be visible.
    if (shortcut.sign == '.') return text + "Period";
    if (shortcut.sign == ',') return text + "Comma";
    if (shortcut.sign != 0) {
        return text + static_cast<char>(std::toupper(static_cast<int>(shortcut.sign)));
    }
    if (shortcut.code == key::kDelete) return text + "Del";
    if (shortcut.code == key::kSpace) return text + "Space";
    if (shortcut.code == key::kEscape) return text + "Esc";
    if (shortcut.code == key::kHome) return text + "Home";
    if (shortcut.code == key::kUp) return text + "Up";
    if (shortcut.code == key::kDown) return text + "Down";
    if (shortcut.code >= key::kF1) return text + "F" + std::to_string(shortcut.code - key::kF1 + 1);
    return {};
}

void run_shortcuts(App& app, std::span<const KeyPress> pressed) {
    const bool dialog = app.ui.dialog != kNoDialog || app.ui.chooser.is_open || app.ui.question;
    if (dialog || app.palette.open) return;
    if (is_popup_open()) {
        if (was_pressed(pressed, key::kEscape)) ImGui::ClosePopupToLevel(0, true);
        return;
    }
    for (const KeyPress& press : pressed) {
        for (const Command& command : commands()) {
            if (!matches(command.shortcut, press)) continue;
            if (is_text_active() && belongs_to_text(command.shortcut)) continue;
            if (is_meant_for_field(app, command.shortcut)) continue;
            const bool arrow = press.code == key::kUp || press.code == key::kDown;
            if (arrow && app.ui.keyboard_mode) continue;
            if (command.enabled(app)) run(app, command);
            break;
        }
    }
}

void draw_palette(App& app, std::span<const KeyPress> pressed) {
    PaletteState& state = app.palette;
    if (app.ui.question) state.open = false;
    if (!state.open) return;
    const ImVec2 screen = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos({screen.x / 2.0F, screen.y * 0.18F}, ImGuiCond_Always, {0.5F, 0.0F});
    ImGui::SetNextWindowSize({std::min(560.0F * app.ui.theme.scale, screen.x * 0.9F), 0.0F});
    ImGui::SetNextWindowFocus();
    ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, app.ui.theme.hairline_px);
    if (ImGui::Begin("Command palette", &state.open,
                     ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoSavedSettings |
                         ImGuiWindowFlags_NoNav)) {
        ImGui::SetNextItemWidth(-1.0F);
        if (ImGui::IsWindowAppearing()) focus_next_item();
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
        const int more = last + 1 - std::min(last + 1, first + shown);
        if (more > 0) dim_text(app.ui, std::to_string(more) + " more: go down, or type some of it");
        if (was_pressed(pressed, key::kEnter) && !found.empty()) {
            chosen = found[static_cast<std::size_t>(state.choice)];
        }
        if (was_pressed(pressed, key::kEscape)) state.open = false;
        if (chosen != nullptr && chosen->enabled(app)) {
            state.open = false;
            carry_out(app, *chosen);
        }
    }
    ImGui::End();
    ImGui::PopStyleVar();
}

}  // namespace tact
