// The parts that the tab is drawn from. Private to the room.
#pragma once

#include "app/document/workspace.h"
#include "app/library/library.h"
#include "app/ui/ui.h"

namespace tact {

// Which folder it is, and what can be done with it.
void draw_library_folder(Ui& ui, const Workspace& work, Layout& layout, LibraryState& state);

// Words, a drawn shape, and the pattern that entries are compared with.
void draw_library_search(Ui& ui, const Workspace& work, LibraryState& state);

// What the order of the list is, with a way back; or what is under way.
void draw_library_order(Ui& ui, const Workspace& work, LibraryState& state);

// The entries, and what can be done with those that are chosen.
void draw_library_list(Ui& ui, Workspace& work, LibraryState& state);

}  // namespace tact
