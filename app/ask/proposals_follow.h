// Recomputes proposed patterns when their question changes: the track of a number, a suggestion,
// variants.
#pragma once

#include "app/ask/proposals_state.h"
#include "app/document/workspace.h"
#include "app/map/map_look.h"
#include "app/map/map_state.h"
#include "app/ui/ui.h"

namespace tact {

// Call once a frame, after the panes: the rested number and the suggestion are those of this frame.
void follow_proposals(const Ui& ui, const Workspace& work, const ShownMap& shown_map,
                      ProposalsState& state);

bool is_asking(const ProposalsState& state);

// The proposals known so far, for the map on screen.
MapMaybes shown_proposals(const ShownMap& shown_map, const ProposalsState& state);

// Whether neighbours can be asked for: the pattern can be edited and is in a map, which needs three
// patterns.
bool can_vary(const Workspace& work);

// Asks for neighbours of the pattern in the editor; called again, for other ones.
void vary(Ui& ui, const Workspace& work, ProposalsState& state);
void stop_varying(ProposalsState& state);
std::shared_ptr<const FoundProposals> found_variants(const ProposalsState& state);

// Gives the pattern the numbers of its k-th neighbour: one step of undo.
void take_variant(Ui& ui, Workspace& work, ProposalsState& state, std::size_t k);

}  // namespace tact
