// Places of the panes: list, map and answers side by side with the editor below the last two, or
// three columns, two of them split. Bars between the panes change their shares.
#pragma once

#include "app/map/map_look.h"
#include "app/window/app.h"
#include "viz/drawing/geometry.h"

namespace tact {

// All panes, or the one that fills the window.
void draw_columns(App& app, const Rect& area);

// A lesson on the whole screen: its card, and only the pane that the step shows.
void draw_presentation(App& app);

// The view of studies, in place of the panes.
void draw_study_columns(App& app, const Rect& area);

// The place of the middle column, for popups beside it.
Rect physiology_area(const App& app, const Rect& columns);

// One pane with its title and content.
void draw_pane_of(App& app, Pane pane, const Rect& area);

// Controls drawn over a pane.
std::string name_of_pane(const App& app, Pane pane);

// Marks that all rooms draw over the map.
MapMarks map_marks(App& app);

}  // namespace tact
