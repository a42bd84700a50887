// The selected pattern drawn to scale, everything on it to be taken by the mouse.
#pragma once

#include "app/document/workspace.h"
#include "app/ui/ui.h"
#include "app/wave_strip/strip_state.h"

namespace tact {

// The time that all views share. The strip shows the range and a little more at the right, where
// the end of the pattern is taken.
struct StripTime {
    TimeRange range;  // of no length: the whole pattern
    double playhead_s = 0.0;
};

// What the strip has of its pane's height.
struct StripRoom {
    float most_px;
    bool fills = false;  // all of it; else it is as high as the person made it, where that is less
};

// As wide as what is left of the pane; nothing without a parametric pattern.
void draw_wave_strip(Ui& ui, Workspace& work, StripState& strip, StripTime& time,
                     const StripRoom& room);

// The numbers of what is chosen on it, if anything is, and a line below them; and how high that is
// at the width that is left of the pane, px.
void draw_chosen_fields(Ui& ui, Workspace& work, StripState& strip);
float chosen_fields_px(const Ui& ui, const Workspace& work, const StripState& strip);

// With the bar under it, px.
float strip_height(const Ui& ui, const StripState& strip);

// By keys: a point of a line (`level` or `frequency`) or a transient, at a time; and the next one,
// or the one before, of points and transients, or with their tool of notes, whose numbers are then
// shown and nudged.
void add_at(Ui& ui, Workspace& work, StripState& strip, GripKind kind, double time_s);
void choose_next(Ui& ui, const Workspace& work, StripState& strip, int step);

// What Del does while a point, a transient or notes are chosen. False: none are.
bool remove_chosen(Ui& ui, Workspace& work, StripState& strip);

}  // namespace tact
