// The tab of the library: a list that is searched by words, by a drawn shape and by what feels like
// a pattern; what is chosen is added to the set, by a button, a double click or by dragging it out.
#pragma once

#include "app/document/workspace.h"
#include "app/library/library_state.h"
#include "app/ui/ui.h"

namespace tact {

void draw_library_panel(Ui& ui, Workspace& work, LibraryState& state);

}  // namespace tact
