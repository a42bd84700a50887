// Above the stages: which of them is large, and which pattern is shown for comparison.
#pragma once

#include "app/document/workspace.h"
#include "app/physiology/physiology_panel.h"
#include "app/physiology/physiology_state.h"
#include "app/ui/ui.h"

namespace tact {

void draw_strip(Ui& ui, Physiology& physiology);

// Comparing, the tour and the way back to one row: at the right end of the strip's last line, else
// below it. What was asked for; `tour_begun`: the tour can be taken up again.
PhysiologyDeed draw_strip_links(Ui& ui, Workspace& work, bool tour_begun);

}  // namespace tact
