// The list of patterns: search, order, names, locks.
#pragma once

#include "app/document/workspace.h"
#include "app/patterns/pattern_menu.h"
#include "app/patterns/patterns_state.h"
#include "app/ui/ui.h"

namespace tact {

PatternAction draw_set_panel(Ui& ui, Workspace& work, PatternPanes& pattern_panes);

// Its search field takes the keyboard in the next frame.
void begin_rename(const Workspace& work, PatternPanes& pattern_panes, std::size_t index);

}  // namespace tact
