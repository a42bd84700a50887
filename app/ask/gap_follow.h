// Filling the gap in a pick, and growing a pick to a number of patterns. Each search runs in the
// background, and its answer is one step of undo.
#pragma once

#include <cstddef>
#include <string>

#include "app/ask/gap_state.h"
#include "app/ask/proposals_state.h"
#include "app/document/workspace.h"
#include "app/map/map_state.h"
#include "app/ui/ui.h"

namespace tact {

// Searches the pattern that is farthest from all picked ones; without a pick, from all of the set.
void fill_the_gap(Ui& ui, const Workspace& work, const ShownMap& shown_map, ProposalsState& state);

// Searches the patterns that are missing to `count`.
void grow_to(Ui& ui, const Workspace& work, const ShownMap& shown_map, ProposalsState& state,
             std::size_t count);

// Once a frame: puts found patterns into the set, and reports their distance and whether it is
// proven.
void follow_gap(Ui& ui, Workspace& work, ProposalsState& state);
void stop_filling(ProposalsState& state);
bool is_filling(const ProposalsState& state);

// "PM 31.0 of 66.0 or more from all others: the farthest of 36 of the design space, proven."
std::string sentence_on(const FoundGap& found);

}  // namespace tact
