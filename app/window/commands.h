// All commands of the program in one table, from which menus, shortcuts and the command palette are
// made.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "app/screen/input_queue.h"
#include "app/window/app.h"

namespace tact {

struct Shortcut {
    char32_t sign = 0;         // the sign that the key writes: layouts differ in its place
    int code = key::kUnknown;  // for keys that write no sign
    bool ctrl = false;
    bool shift = false;
};

constexpr Shortcut ctrl(char32_t sign, bool shift = false) {
    return {sign, key::kUnknown, true, shift};
}
constexpr Shortcut plain(char32_t sign) { return {sign, key::kUnknown, false, false}; }
constexpr Shortcut special(int code, bool shift = false) { return {0, code, false, shift}; }

struct Command {
    const char* menu;  // "Edit"
    const char* name;
    Shortcut shortcut;
    bool (*enabled)(const App&);
    void (*run)(App&);
    bool (*checked)(const App&) = nullptr;
    const char* words = "";  // more words by which the palette finds it
};

inline constexpr const char* kExampleMenu = "Example sets";  // within File

std::span<const Command> commands();
std::span<const Command> document_commands();  // the order of menus: File, Edit ...
std::span<const Command> view_commands();      // ... and View

// Runs it, and notes its name for crash reports.
void carry_out(App& app, const Command& command);

// The reason why it is disabled; null: it can run.
const char* what_lacks(const App& app, const Command& command);

// "Ctrl+Shift+Z"; empty without one.
std::string shortcut_text(const Shortcut& shortcut);

// The name; for Undo and Redo with the step's label.
std::string item_text(const App& app, const Command& command);

// Its place: "View > Map > Frame the selection in the space".
std::string menu_path(const Command& command);

// Runs the commands of this frame's key presses. While text is being typed, only Ctrl combinations
// that text fields do not use.
void run_shortcuts(App& app, std::span<const KeyPress> pressed);

void draw_menus(App& app);

// A right click that nothing else in the pane takes: a menu for the pane as a whole.
void draw_pane_menu(App& app, Pane pane);

// Commands that begin a group in their menu, below a line.
std::span<const std::string_view> menu_groups();

// The command palette: every command, found by a few letters of its name.
void draw_palette(App& app, std::span<const KeyPress> pressed);

}  // namespace tact
