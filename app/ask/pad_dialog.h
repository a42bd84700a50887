// The pad: a square with patterns in its corners; inside it is their mix, seen and felt.
#pragma once

#include <string>
#include <vector>

#include "app/ask/pad_state.h"
#include "app/document/workspace.h"
#include "app/ui/ui.h"

namespace tact {

// What is selected and made of parameters, four at most, the one in the editor first.
std::vector<std::string> pad_corners(const Workspace& work);

// On these, where there are two at least.
void open_pad(Ui& ui, const Workspace& work, PadState& pad);

// Enter adds the mix behind the first corner: one step of undo. Esc leaves the set as it is.
void draw_pad_dialog(Ui& ui, Workspace& work, PadState& pad);

}  // namespace tact
