// One stage of one pattern, or of two with their difference between them, each under its name.
#pragma once

#include <vector>

#include "app/document/workspace.h"
#include "app/physiology/physiology_state.h"
#include "app/physiology/stage_views.h"
#include "app/timeline/timeline.h"
#include "app/ui/ui.h"
#include "viz/drawing/geometry.h"

namespace tact {

void draw_patterns(Ui& ui, const Workspace& work, Timeline& timeline, Physiology& physiology,
                   const std::vector<ShownStages>& patterns, Stage stage, const Rect& area,
                   const StageSize& size);

// What misleads in the stage of the first pattern, `down_px` below the pane's top; the height that
// it takes.
float draw_remark(Ui& ui, const std::vector<ShownStages>& patterns, Stage stage, const Rect& pane,
                  float down_px);

}  // namespace tact
