// The menu of a pattern, on its row, its point and its line in the table.
#pragma once

#include <cstddef>

#include "app/document/workspace.h"
#include "app/ui/ui.h"

namespace tact {

// Choices that the frame carries out, because they need more than this room knows.
enum class PatternAction { none, play, rename, similar, vary, steps, transform };

// Call inside an open popup. Selects the pattern, unless it is among the selected ones: choices
// apply to all of them, and are carried out after the frame's lists are drawn. `play_key` plays it,
// too.
PatternAction draw_pattern_menu(Ui& ui, Workspace& work, std::size_t index,
                                const char* play_key = "");

// The same, opened by a right click on the last item, a row of a list; it stands beside the row,
// whose name stays visible.
PatternAction draw_row_menu(Ui& ui, Workspace& work, std::size_t index, const char* play_key = "");

}  // namespace tact
