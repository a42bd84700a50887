// The views of the Subset tab.
#pragma once

#include "app/window/app.h"
#include "viz/drawing/geometry.h"

namespace tact {

void draw_pick_view(App& app);
void draw_too_close_view(App& app);
void draw_stability_view(App& app);

// How far apart the weakest pair is for each count; a click chooses one.
bool has_curve(const App& app);  // or will have
void draw_curve(App& app, const Rect& area);

// What is left of the pane, or where that is less so many lines, which scroll.
Rect rest_or_lines(float lines);

// Text in a colour, wrapped at the pane's edge.
void coloured_note(ImU32 colour, const std::string& text);

}  // namespace tact
