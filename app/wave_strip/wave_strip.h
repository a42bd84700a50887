// The selected pattern drawn to scale, everything on it to be taken by the mouse.
#pragma once

#include "app/document/workspace.h"
#include "app/ui/ui.h"
#include "app/wave_strip/strip_state.h"

namespace tact {

// As wide as what is left of the pane, and lower than the person made it where only `most_px` are
// free; nothing without a parametric pattern.
void draw_wave_strip(Ui& ui, Workspace& work, StripState& strip, float most_px);

// With the bar under it, px.
float strip_height(const Ui& ui, const StripState& strip);

// By keys: a point of a line (`level` or `frequency`) or a transient, at a time; and the next one,
// or the one before, of points and transients, whose numbers are then shown and nudged.
void add_at(Ui& ui, Workspace& work, StripState& strip, GripKind kind, double time_s);
void choose_next(Ui& ui, const Workspace& work, StripState& strip, int step);

// What Del does while a point or a transient is chosen. False: none is.
bool remove_chosen(Ui& ui, Workspace& work, StripState& strip);

}  // namespace tact
