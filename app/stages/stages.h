// The stages of the model for the current pattern, and the text about a stage beside its pane.
#pragma once

#include "app/document/workspace.h"
#include "app/physiology/physiology.h"
#include "app/timeline/timeline.h"
#include "app/ui/ui.h"
#include "viz/drawing/geometry.h"

namespace tact {

enum class StagesAction { none, tour, fold, unfold, close };

// Before a frame: forgets the item under the mouse, wherever it was.
void begin_pointing(Timeline& timeline, Physiology& physiology);

// Returns the pressed links. `tour_begun`: offers to continue the tour.
StagesAction draw_physiology_panel(Ui& ui, Workspace& work, Timeline& timeline,
                                   Physiology& physiology, bool tour_begun);

// A few stages side by side; a press on one opens the whole column.
StagesAction draw_physiology_row(Ui& ui, Workspace& work, Timeline& timeline,
                                 Physiology& physiology);
void draw_explain_window(Ui& ui, Physiology& physiology, const Rect& beside);

}  // namespace tact
