// The selected pattern drawn to scale, with grips for the mouse.
#pragma once

#include "app/document/workspace.h"
#include "app/ui/ui.h"
#include "app/wave_strip/strip_state.h"

namespace tact {

// The time axis of all views. The strip shows the range and a little more at the right, where the
// grip of the pattern's end is.
struct StripTime {
    TimeRange range;  // length 0: the whole pattern
    double playhead_s = 0.0;
};

// The strip's share of its pane.
struct StripRoom {
    float most_px;
    bool fills = false;  // fills the height; false: the height set by the person, if there is room
};

// As wide as the rest of the pane; draws nothing without a parametric pattern.
void draw_wave_strip(Ui& ui, Workspace& work, StripState& strip, StripTime& time,
                     const StripRoom& room);

// The numbers of the chosen item, if any, with a line below them; and their height in px at the
// width of the rest of the pane.
void draw_chosen_fields(Ui& ui, Workspace& work, StripState& strip);
float chosen_fields_px(const Ui& ui, const Workspace& work, const StripState& strip);

// Including the bar under it, in px.
float strip_height(const Ui& ui, const StripState& strip);

// For keys: adds a point to a line (`level` or `frequency`), or a transient, at a time; and chooses
// the next point or transient, or the one before, or a note with the tool of notes. The chosen
// item's numbers are shown and nudged.
void add_at(Ui& ui, Workspace& work, StripState& strip, GripKind kind, double time_s);
void choose_next(Ui& ui, const Workspace& work, StripState& strip, int step);

// Del removes the chosen point, transient or notes. False: none was chosen.
bool remove_chosen(Ui& ui, Workspace& work, StripState& strip);

}  // namespace tact
