// The dialog in which a rhythm is tapped, by a key or by the mouse.
#pragma once

#include "app/document/workspace.h"
#include "app/patterns/patterns_state.h"
#include "app/ui/ui.h"

namespace tact {

void open_tapping(Ui& ui, TappingState& tapping);

// Enter takes the rhythm for all selected patterns, longer ones make them longer; Esc leaves all as
// it is.
void draw_tapping_dialog(Ui& ui, Workspace& work, TappingState& tapping);

}  // namespace tact
