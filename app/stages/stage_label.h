// What is written beside a stage's plots.
#pragma once

#include <string>

#include "app/physiology/physiology_state.h"
#include "app/ui/ui.h"
#include "viz/drawing/geometry.h"

namespace tact {

// Name and what is plotted, left of the plots; the name opens the stage, the "i" explains it.
// Where it ends.
float draw_stage_label(Ui& ui, Physiology& physiology, Stage stage, const Rect& area);

// How far up and down signals reach, at the foot of the label of a stage that has the room.
void draw_reach(Ui& ui, const Rect& label, Stage stage, const std::string& text);

}  // namespace tact
