// Filling the gap, and growing to as many patterns as are to be picked: each is searched beside the
// window and taken as one step of undo.
#pragma once

#include <cstddef>
#include <string>

#include "app/ask/gap_state.h"
#include "app/ask/maybes_state.h"
#include "app/document/workspace.h"
#include "app/map/map_state.h"
#include "app/ui/ui.h"

namespace tact {

// The one pattern that is farthest from all that are picked, or where none are from all there are.
void fill_the_gap(Ui& ui, const Workspace& work, const ShownMap& shown_map, MaybesState& state);

// As many as are missing to `count`.
void grow_to(Ui& ui, const Workspace& work, const ShownMap& shown_map, MaybesState& state,
             std::size_t count);

// Once a frame: takes what was found, and says how far it lies and how sure that is.
void follow_gap(Ui& ui, Workspace& work, MaybesState& state);
void stop_filling(MaybesState& state);
bool is_filling(const MaybesState& state);

// "PM 31.0 of 66.0 or more from all others: the farthest of 36 of the design space, proven."
std::string sentence_on(const FoundGap& found);

}  // namespace tact
