// The groups of the map on screen, and who stands for them.
#pragma once

#include <vector>

#include "app/document/workspace.h"
#include "app/map/map_state.h"
#include "app/subset/subset_state.h"
#include "app/ui/layout.h"
#include "app/ui/ui.h"

namespace tact {

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

}  // namespace tact
