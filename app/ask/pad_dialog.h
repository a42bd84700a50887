// The pad: a square with patterns in its corners; inside it is their mix, seen and felt.
#pragma once

#include "app/ask/pad_state.h"
#include "app/document/workspace.h"
#include "app/ui/ui.h"

namespace tact {

// On what is selected: two to four patterns made of parameters, the one in the editor first.
void open_pad(Ui& ui, const Workspace& work, PadState& pad);

// Enter adds the mix behind the first corner: one step of undo. Esc leaves the set as it is.
void draw_pad_dialog(Ui& ui, Workspace& work, PadState& pad);

}  // namespace tact
