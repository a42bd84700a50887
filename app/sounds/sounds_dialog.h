// The dialog on sounds: for which actuator, what is heard beside what would be felt, what is lost.
#pragma once

#include "app/document/workspace.h"
#include "app/sounds/sounds_state.h"
#include "app/ui/ui.h"

namespace tact {

void draw_sounds_dialog(Ui& ui, Workspace& work, SoundsState& sounds);

}  // namespace tact
