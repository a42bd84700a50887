// The tabs that compare: metrics with people, the map with its distances, two patterns.
#pragma once

#include "app/window/app.h"
#include "viz/drawing/geometry.h"

namespace tact {

void draw_compare_panel(App& app);
void draw_shepard_panel(App& app);
void draw_why_panel(App& app);
void draw_findings(App& app, const Rect& area);

}  // namespace tact
