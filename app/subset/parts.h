// Parts that the files of this room share.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "app/document/workspace.h"
#include "app/map/map.h"
#include "app/patterns/patterns.h"
#include "app/play/play.h"
#include "app/subset/subset.h"
#include "app/timeline/timeline.h"
#include "app/ui/ui.h"
#include "app/ui/widgets.h"
#include "viz/drawing/geometry.h"

namespace tact {

// Subsets beside the best one: which are as good, or nearly.

// Name of a pattern when it was picked.
const std::string& name_of(const Pick& pick, std::size_t member);

// Which pattern replaces which in each. A click shows it in the place of the best.
void draw_alternatives(Ui& ui, SubsetState& picking, const Pick& pick);
// How high they are at such a width.
float alternatives_px(const Ui& ui, const SubsetState& picking, const Pick& pick, float width_px);

// The groups of the map on screen, and who stands for them.

// Asks for the tree of the map on screen while the groups are looked at.
void follow_groups(const Ui& ui, const ShownMap& shown_map, const Layout& layout,
                   SubsetState& picking);

// The groups of the map on screen; null: not there yet.
const FoundGroups* shown_groups(const ShownMap& shown_map, const SubsetState& picking);

// The groups on screen as they are cut now; there must be a tree.
const CutGroups& cut_groups(SubsetState& picking);
// The height at which the line stands: where it was put, or in the middle of the cuts that leave
// as many groups as were asked for.
double cut_height(const SubsetState& picking);

// The look of a group's patterns: those of one pattern have no colour of their own.
PatternLook group_look(const Theme& theme, const CutGroups& cut, std::size_t group);

// Locks what stands for the groups, as one step, and shows it as the subset. What stood for groups
// before and was locked for that is free again.
void keep_groups(Ui& ui, Workspace& work, const ShownMap& shown_map, SubsetState& picking);

// The views of the Subset tab.

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
