// Everything the program can be told to do, in one table: menus, shortcuts and the command palette
// are made from it.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "app/screen/input_queue.h"
#include "app/window/app.h"

namespace tact {

struct Shortcut {
    char32_t sign = 0;         // what the key writes: layouts differ in where it sits
    int code = key::kUnknown;  // for keys that write nothing
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
    const char* words = "";  // that the palette finds it by, besides its name
};

inline constexpr const char* kExampleMenu = "Example sets";  // within File

std::span<const Command> commands();
std::span<const Command> document_commands();  // the first of them: File, Edit ...
std::span<const Command> view_commands();      // ... and View

// Runs it, and notes its name for what a crash would tell.
void carry_out(App& app, const Command& command);

// Why it cannot be run; none: it can.
const char* what_lacks(const App& app, const Command& command);

// "Ctrl+Shift+Z"; empty without one.
std::string shortcut_text(const Shortcut& shortcut);

// The name; of undoing and redoing with what they would undo.
std::string item_text(const App& app, const Command& command);

// Where it stands: "View > Map > Frame the selection in the space".
std::string menu_path(const Command& command);

// Runs the commands of this frame's key presses. While text is being typed only Ctrl combinations
// count that text fields do not use themselves.
void run_shortcuts(App& app, std::span<const KeyPress> pressed);

void draw_menus(App& app);

// A right click where nothing else in the pane takes it: what can be done with it as a whole.
void draw_pane_menu(App& app, Pane pane);

// The commands that begin a group in their menu, after a line.
std::span<const std::string_view> menu_groups();

// Every command by a few letters of its name; where it is open.
void draw_palette(App& app, std::span<const KeyPress> pressed);

}  // namespace tact
