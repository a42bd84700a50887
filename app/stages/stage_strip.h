// The strip above the stages: the large stage, and the pattern shown for comparison.
#pragma once

#include "app/document/workspace.h"
#include "app/physiology/physiology_state.h"
#include "app/stages/physiology_panel.h"
#include "app/ui/ui.h"

namespace tact {

// The strip; links to compare, to the tour and back to one row stand at the right end of its last
// line, or below it, or in a menu if it has two lines already. Returns the pressed links.
// `tour_begun`: offers to continue the tour.
StagesAction draw_strip(Ui& ui, Workspace& work, Physiology& physiology, bool tour_begun);

}  // namespace tact
