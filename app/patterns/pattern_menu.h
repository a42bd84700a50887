// What can be done with a pattern, as a menu: of its row, of its point and of its line in the
// table.
#pragma once

#include <cstddef>

#include "app/document/workspace.h"
#include "app/ui/ui.h"

namespace tact {

// What the frame does with the current pattern, since more is needed for it than is known here.
enum class PatternDeed { none, play, rename, similar, vary, steps, transform };

// Within a popup that is open. The pattern is selected first, unless it is one of those selected:
// what follows is for all of them. They are changed once the frame's lists are drawn. `play_key`
// plays it, too.
PatternDeed draw_pattern_menu(Ui& ui, Workspace& work, std::size_t index,
                              const char* play_key = "");

// The same by a right click on the last item, a row of a list; beside the row, whose name stays in
// sight.
PatternDeed draw_row_menu(Ui& ui, Workspace& work, std::size_t index, const char* play_key = "");

}  // namespace tact
