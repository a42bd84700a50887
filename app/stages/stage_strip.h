// Above the stages: which of them is large, and which pattern is shown for comparison.
#pragma once

#include "app/document/workspace.h"
#include "app/physiology/physiology_state.h"
#include "app/stages/physiology_panel.h"
#include "app/ui/ui.h"

namespace tact {

// The strip, and comparing, the tour and the way back to one row: at the right end of its last
// line, else below it, and in a menu where it has two lines already. What was asked for;
// `tour_begun`: the tour can be taken up again.
PhysiologyDeed draw_strip(Ui& ui, Workspace& work, Physiology& physiology, bool tour_begun);

}  // namespace tact
