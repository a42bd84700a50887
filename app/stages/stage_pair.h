// A stage of one pattern, or of two with their difference between them, each under its name.
#pragma once

#include <vector>

#include "app/document/workspace.h"
#include "app/physiology/physiology_state.h"
#include "app/stages/stage_views.h"
#include "app/timeline/timeline.h"
#include "app/ui/ui.h"
#include "viz/drawing/geometry.h"

namespace tact {

void draw_patterns(Ui& ui, const Workspace& work, Timeline& timeline, Physiology& physiology,
                   const std::vector<ShownStages>& patterns, Stage stage, const Rect& area,
                   const StageSize& size);

// Remarks on the first pattern: in `beside` if they fit in one line, otherwise at the top of
// `below`; returns the height used there.
float draw_remark(Ui& ui, const Physiology& physiology, const std::vector<ShownStages>& patterns,
                  Stage stage, const Rect& beside, const Rect& below);

}  // namespace tact
