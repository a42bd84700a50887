// Keeping the picked subset, and what is asked about it, in step with the document.
#pragma once

#include <set>
#include <string>

#include "app/document/workspace.h"
#include "app/map/map_state.h"
#include "app/subset/subset_state.h"
#include "app/ui/layout.h"
#include "app/ui/ui.h"

namespace tact {

// Takes what the jobs have finished; asks again if the document or the question has changed.
void follow_subset(const Ui& ui, const Workspace& work, const Layout& layout,
                   const ShownMap& shown_map, SubsetState& picking);

// The subset on screen, of the map on screen; null: none. It may answer an earlier question ...
const Pick* shown_pick(const ShownMap& shown_map, const SubsetState& picking);
// ... and then is not that of the present document.
bool is_pick_stale(const Workspace& work, const ShownMap& shown_map, const SubsetState& picking);
// By coarse envelopes: shown at once, and asked for again when the map is exact.
bool is_of_preview(const PickRequest& request);
// Another may take its place without a further question: it is by a preview, or was found by now.
bool is_unsettled(const Pick& pick);
// Names of the members of the subset on screen.
std::set<std::string> picked_names(const ShownMap& shown_map, const SubsetState& picking);
// The best one, or the alternative that is looked at.
const Subset* shown_subset(const ShownMap& shown_map, const SubsetState& picking);
// A search runs, or follow_subset has not yet taken what it found.
bool is_picking(const SubsetState& picking);
bool is_subset_busy(const SubsetState& picking);  // with anything
void cancel_picking(SubsetState& picking);

// Variants of the model, asked of the subset on screen; null: nobody asked yet.
void ask_for_stability(const Ui& ui, SubsetState& picking, std::size_t draws);
const FoundStability* found_stability(const SubsetState& picking);
const Stability* shown_stability(const SubsetState& picking);

}  // namespace tact
