// The dialog for tapping a rhythm with a key or the mouse.
#pragma once

#include "app/document/workspace.h"
#include "app/patterns/patterns_state.h"
#include "app/ui/ui.h"

namespace tact {

void open_tapping(Ui& ui, TappingState& tapping);

// Enter gives the rhythm to all selected patterns, and lengthens patterns that are too short for
// it; Esc changes nothing.
void draw_tapping_dialog(Ui& ui, Workspace& work, TappingState& tapping);

}  // namespace tact
