// The views of the Subset tab.
#pragma once

#include "app/app.h"

namespace tact {

void draw_pick_view(App& app);
void draw_too_close_view(App& app);
void draw_stability_view(App& app);

// Text in a colour, wrapped at the pane's edge.
void coloured_note(ImU32 colour, const std::string& text);

}  // namespace tact
