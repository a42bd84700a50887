// Text beside a stage's plots.
#pragma once

#include <string>

#include "app/physiology/physiology_state.h"
#include "app/ui/ui.h"
#include "viz/drawing/geometry.h"

namespace tact {

// Name and quantity, left of the plots; the name opens the stage, the "i" explains it.
// Returns the lower end.
float draw_stage_label(Ui& ui, Physiology& physiology, Stage stage, const Rect& area);

// Largest value up and down, at the bottom of the label if there is room.
void draw_reach(Ui& ui, const Rect& label, Stage stage, const std::string& text);

}  // namespace tact
