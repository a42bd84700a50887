// Which command a key means, and when it is for a text field or a dialog instead.

#include <imgui_internal.h>

#include <cctype>

#include "app/ui/dialog.h"
#include "app/window/commands.h"

namespace tact {

namespace {

bool matches(const Shortcut& shortcut, const KeyPress& press) {
    if (shortcut.ctrl != press.ctrl || press.alt || press.super) return false;
    if (shortcut.code != key::kUnknown) {
        return shortcut.code == press.code && shortcut.shift == press.shift;
    }
    if (shortcut.sign == 0 || shortcut.sign != press.sign) return false;
    // On many layouts + is Shift and something: signs that are no letters ignore Shift.
    const bool letter = shortcut.sign >= 'a' && shortcut.sign <= 'z';
    return !letter || shortcut.shift == press.shift;
}

// Ctrl+Z, C, V, A, Y and the keys that move in text belong to a text field while it is active.
bool belongs_to_text(const Shortcut& shortcut) {
    if (!shortcut.ctrl) return shortcut.code < key::kF1 || shortcut.sign != 0;
    constexpr std::u32string_view kText = U"zycvxa";
    return kText.find(shortcut.sign) != std::u32string_view::npos;
}

// ImGui wants text for one frame longer than a field is active: the first key after Enter is not
// its own.
bool is_text_active() { return ImGui::GetIO().WantTextInput && ImGui::IsAnyItemActive(); }

// What is typed at a field that is locked, or whose slider is held, would have been a number.
bool is_meant_for_field(const App& app, const Shortcut& shortcut) {
    const bool is_digit = !shortcut.ctrl && shortcut.sign >= '0' && shortcut.sign <= '9';
    return is_digit && (!app.ui.field.locked.empty() || ImGui::IsAnyItemActive());
}

// Changes the document, or which part of it is edited.
bool touches_document(const Command& command) {
    const std::string_view menu = command.menu;
    if (menu.empty()) return command.shortcut.code != key::kEscape;
    return menu == "File" || menu == "Edit";
}

// A drag or an entry in mid-air ends first, on the pattern it began on: it takes its value and its
// undo step while the panels are drawn, and the command follows in the same frame.
void run(App& app, const Command& command) {
    if (!ImGui::IsAnyItemActive() || !touches_document(command)) return carry_out(app, command);
    ImGui::ClearActiveID();
    app.ui.waiting.emplace_back([&app, &command] { carry_out(app, command); });
}

}  // namespace

std::string shortcut_text(const Shortcut& shortcut) {
    std::string text;
    if (shortcut.ctrl) text += "Ctrl+";
    if (shortcut.shift) text += "Shift+";
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
    const bool dialog = app.ui.dialog != Dialog::none || app.ui.chooser.is_open || app.ui.question;
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

}  // namespace tact
