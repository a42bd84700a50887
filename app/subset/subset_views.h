// The views of the Subset tab.
#pragma once

#include <string>

#include "app/document/workspace.h"
#include "app/map/map_state.h"
#include "app/patterns/pattern_menu.h"
#include "app/play/play_state.h"
#include "app/subset/subset_state.h"
#include "app/timeline/timeline.h"
#include "app/ui/ui.h"
#include "viz/drawing/geometry.h"

namespace tact {

// The worth of a subset or a pair, with the digits that reports and exports show.
std::string worth_text(double worth);

PatternAction draw_pick_view(Ui& ui, Workspace& work, Timeline& timeline, const ShownMap& shown_map,
                             PlayState& play, SubsetState& picking);
void draw_groups_view(Ui& ui, Workspace& work, const ShownMap& shown_map, SubsetState& picking);
void draw_too_close_view(Ui& ui, Workspace& work, const ShownMap& shown_map, SubsetState& picking);
void draw_stability_view(Ui& ui, const Workspace& work, const ShownMap& shown_map,
                         SubsetState& picking);

// How far apart the weakest pair is for each count; a click chooses one.
bool has_curve(const SubsetState& picking);  // or will have
std::string quantity_of(const PickRequest& request,
                        const NumberMark& mark);  // what "far apart" is in: "PM"
void draw_curve(Ui& ui, const ShownMap& shown_map, SubsetState& picking, const Rect& area);

// What is left of the pane, or, if that is less, `lines` lines, which scroll.
Rect rest_or_lines(float lines);

}  // namespace tact
