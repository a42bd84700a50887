// How a pattern looks wherever it is shown: mark, colour, and a small picture of its waveform.
#pragma once

#include <string>

#include "app/document/workspace.h"
#include "app/ui/ui.h"
#include "viz/drawing/geometry.h"
#include "viz/drawing/marks.h"

namespace tact {

// Mark and colour of the pattern at a position: its own (default: by position).
PatternLook look_of(const Theme& theme, const PatternSet& set, std::size_t index);
PatternLook look_of(const Ui& ui, const Workspace& work, std::size_t index);

// Patterns without a colour get the look that is least used, in the order of the palette. Whoever
// has one keeps it.
void give_looks(PatternSet& set);

// One step: colour, "#RRGGBB", and mark of all that is selected.
void change_look(Ui& ui, Workspace& work, const std::string& colour, bool ring);

// What a waveform is drawn up to where all of the set have one scale, g; 0: up to its own peak.
double shown_reach_g(const Workspace& work);

// "22 ms", "1.5 s".
std::string length_text(double length_s);

// The waveform of a vibration without axes, over so much time; 0: over its own length.
void draw_thumbnail(const Ui& ui, Workspace& work, const Rect& area, const Vibration& vibration,
                    ImU32 colour, double reach_g, double axis_s = 0.0);

// What lies under a row of the set: selected, one of several, or pointed at.
void draw_row_ground(const Ui& ui, const Workspace& work, std::size_t index, const Rect& row);

// Signs of what holds for a pattern besides its numbers, locked or dropped, up to `right`; how wide
// they are, with the gap before them.
float state_signs_px(const Theme& theme, const Vibration& vibration);
void draw_state_signs(Ui& ui, const Vibration& vibration, ImVec2 right);

// All words of a set that are drawn: what fonts need glyphs for.
std::string drawn_text(const PatternSet& set);

}  // namespace tact
