// The pad: a square with patterns in its corners. A point inside it is their mix, seen and felt.
#pragma once

#include <string>
#include <vector>

#include "app/ask/pad_state.h"
#include "app/document/workspace.h"
#include "app/ui/ui.h"

namespace tact {

// The selected parametric patterns, at most four, the one in the editor first.
std::vector<std::string> pad_corners(const Workspace& work);

// Opens the pad on these names; there must be at least two.
void open_pad(Ui& ui, const Workspace& work, PadState& pad);

// Enter adds the mix behind the first corner as one step of undo. Esc leaves the set unchanged.
void draw_pad_dialog(Ui& ui, Workspace& work, PadState& pad);

}  // namespace tact
