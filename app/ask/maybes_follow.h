// Recomputes proposed patterns when their question changes: the track of a number, a suggestion,
// variants.
#pragma once

#include "app/ask/maybes_state.h"
#include "app/document/workspace.h"
#include "app/map/map_look.h"
#include "app/map/map_state.h"
#include "app/ui/ui.h"

namespace tact {

void make_maybes_jobs(const Ui& ui, MaybesState& state);
void stop_maybes_jobs(MaybesState& state);

// Call once a frame, after the panes: the rested number and the suggestion are those of this frame.
void follow_maybes(const Ui& ui, const Workspace& work, const ShownMap& shown_map,
                   MaybesState& state);

bool is_asking(const MaybesState& state);

// The proposals known so far, for the map on screen.
MapMaybes shown_maybes(const ShownMap& shown_map, const MaybesState& state);

// Whether neighbours can be asked for: the pattern can be edited and is in a map, which needs three
// patterns.
bool can_vary(const Workspace& work);

// Asks for neighbours of the pattern in the editor; called again, for other ones.
void vary(Ui& ui, const Workspace& work, MaybesState& state);
void stop_varying(MaybesState& state);
std::shared_ptr<const FoundMaybes> found_variants(const MaybesState& state);

// Gives the pattern the numbers of its k-th neighbour: one step of undo.
void take_variant(Ui& ui, Workspace& work, MaybesState& state, std::size_t k);

}  // namespace tact
