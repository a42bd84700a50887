// Opening files, and adding them to the set, in the background: a frame never waits for a file.
//
// Input     paths of sets, folders, recordings and effects, as model/io/set/load.h takes them
// Output    another document, or one undoable step in the open one; an error changes nothing
// Valid     One opening at a time. A newer one takes the place of an older; what is to be added
//           while something is read is refused. What was read waits while a question, a dialog or
//           a hand is on the document, and is added to no other set than it was asked for.
// Left out  a job, as before the window is there: then files are read in place.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/document/workspace.h"
#include "app/opening/opening_state.h"
#include "app/ui/ui.h"

namespace tact {

// As one set, in the place of the open one. Unsaved changes of that one are kept in a file of their
// own; where they cannot be, it stays.
void open_paths(Ui& ui, Workspace& work, Opening& opening,
                const std::vector<std::filesystem::path>& paths, bool partly = false);

// Behind the current pattern, as one step; names that are taken get a number.
void add_paths(Ui& ui, Workspace& work, Opening& opening,
               const std::vector<std::filesystem::path>& paths, bool partly = false);

// Once a frame. `is_free`: nothing lies over the document, and no hand is on it.
void follow_opening(Ui& ui, Workspace& work, Opening& opening, bool is_free);

bool is_opening(const Opening& opening);
void cancel_opening(Ui& ui, Opening& opening);

// "Reading buzz.haptic, 40 %", with Cancel, at the cursor; false where reading has just begun and
// the line at the foot is better left to what was said last.
bool draw_opening(Ui& ui, Opening& opening);

// The files that could not be read, each with its reason.
void tell_left_out(Ui& ui, const Opening& opening);

}  // namespace tact
