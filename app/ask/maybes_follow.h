// Keeping what there might be in step with what is asked: rested on, suggested, varied.
#pragma once

#include "app/ask/maybes_state.h"
#include "app/document/workspace.h"
#include "app/map/map_look.h"
#include "app/map/map_state.h"
#include "app/ui/ui.h"

namespace tact {

void make_maybes_jobs(const Ui& ui, MaybesState& state);
void stop_maybes_jobs(MaybesState& state);

// Once a frame, after the panes: what is rested on and suggested is of this frame.
void follow_maybes(const Ui& ui, const Workspace& work, const ShownMap& shown_map,
                   MaybesState& state);

bool is_asking(const MaybesState& state);

// What of it is known by now, for the map on screen.
MapMaybes shown_maybes(const ShownMap& shown_map, const MaybesState& state);

// Whether there are neighbours to ask for: of a pattern that can be edited, in a map, which takes
// three.
bool can_vary(const Workspace& work);

// Neighbours of the pattern in the editor are asked for; again: others.
void vary(Ui& ui, const Workspace& work, MaybesState& state);
void stop_varying(MaybesState& state);
std::shared_ptr<const FoundMaybes> found_variants(const MaybesState& state);

// One step: the pattern becomes its k-th neighbour.
void take_variant(Ui& ui, Workspace& work, MaybesState& state, std::size_t k);

}  // namespace tact
