// The dialog for even steps between two patterns.
#pragma once

#include "app/ask/steps_state.h"
#include "app/document/workspace.h"
#include "app/ui/ui.h"

namespace tact {

// Enter adds the steps, Esc leaves the set unchanged. A row is played while it is held.
void draw_steps_dialog(Ui& ui, Workspace& work, StepsState& state);

}  // namespace tact
