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

// The list of keys for F1 and the manual.
std::span<const KeyRow> keys_and_mouse();

// Whether a question or a participant comes first: opening another set would replace the data
// behind them.
bool is_in_the_middle(const App& app);

// Opens dropped files: tables of ratings or of accelerations go to the open set, other files are
// opened.
void drop_paths(App& app, const std::vector<std::filesystem::path>& paths);

}  // namespace tact
