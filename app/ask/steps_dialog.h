// The dialog for even steps between two patterns.
#pragma once

#include "app/ask/steps_state.h"
#include "app/document/workspace.h"
#include "app/ui/ui.h"

namespace tact {

// Enter adds them, Esc leaves the set as it is. Each row is felt while it is held.
void draw_steps_dialog(Ui& ui, Workspace& work, StepsState& state);

}  // namespace tact
