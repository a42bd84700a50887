// The stages of the model for the current pattern, and the text about a stage beside its pane.
#pragma once

#include "app/window/app.h"
#include "viz/drawing/geometry.h"

namespace tact {

// True where the tour was asked for; `tour_begun`: it can be taken up again.
bool draw_physiology_panel(App& app, bool tour_begun);
void draw_explain_window(App& app, const Rect& beside);

}  // namespace tact
