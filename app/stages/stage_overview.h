// All stages below one another.
#pragma once

#include <vector>

#include "app/document/workspace.h"
#include "app/physiology/physiology_state.h"
#include "app/stages/stage_views.h"
#include "app/timeline/timeline.h"
#include "app/ui/ui.h"

namespace tact {

// Stages of one pattern or two; scrolls if the pane is too low.
void draw_overview(Ui& ui, const Workspace& work, Timeline& timeline, Physiology& physiology,
                   const std::vector<ShownStages>& patterns);

}  // namespace tact
