// Dialogs over the window: files, keys, about, and those of every room.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "app/manual/keys_dialog.h"
#include "app/window/app.h"

namespace tact {

void draw_dialogs(App& app);

// What F1 lists, and the manual.
std::span<const KeyRow> keys_and_mouse();

// A question or a participant comes first: another set would change what lies beneath them.
bool is_in_the_middle(const App& app);

// What was dropped on the window: tables of ratings or of accelerations go to the open set, all
// else is opened.
void drop_paths(App& app, const std::vector<std::filesystem::path>& paths);

}  // namespace tact
