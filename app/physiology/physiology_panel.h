// The stages of the model for the current pattern, and the text about a stage beside its pane.
#pragma once

#include "app/document/workspace.h"
#include "app/physiology/physiology_state.h"
#include "app/timeline/timeline.h"
#include "app/ui/ui.h"
#include "viz/drawing/geometry.h"

namespace tact {

// True where the tour was asked for; `tour_begun`: it can be taken up again.
bool draw_physiology_panel(Ui& ui, Workspace& work, Timeline& timeline, Physiology& physiology,
                           bool tour_begun);
void draw_explain_window(Ui& ui, Physiology& physiology, const Rect& beside);

}  // namespace tact
