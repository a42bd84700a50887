// Above the stages: which of them is large, and which pattern is shown for comparison.
#pragma once

#include "app/document/workspace.h"
#include "app/physiology/physiology_state.h"
#include "app/ui/ui.h"

namespace tact {

void draw_strip(Ui& ui, Physiology& physiology);

// True where the tour was asked for; `tour_begun`: it can be taken up again.
bool draw_pin_choice(Ui& ui, Workspace& work, bool tour_begun);

}  // namespace tact
