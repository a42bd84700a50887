// Where the panes are: list, map and answers beside each other with the editor below the last two,
// or three columns, two of them split; the bars between them move the shares.
#pragma once

#include "app/map/map_look.h"
#include "app/window/app.h"
#include "viz/drawing/geometry.h"

namespace tact {

// All panes, or the one that fills the window.
void draw_columns(App& app, const Rect& area);

// A lesson on the whole screen: its card, and beside it nothing but what the step shows.
void draw_presentation(App& app);

// The view of studies in their place.
void draw_study_columns(App& app, const Rect& area);

// Where the middle column is, for what opens beside it.
Rect physiology_area(const App& app, const Rect& columns);

// One pane with its title and content.
void draw_pane_of(App& app, Pane pane, const Rect& area);

// What stands over it.
std::string name_of_pane(const App& app, Pane pane);

// What all rooms lay over the map.
MapMarks map_marks(App& app);

}  // namespace tact
