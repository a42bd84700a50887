// Playing while working: edits of the playing pattern, the item under the pressed mouse, and two
// patterns in turn.
#pragma once

#include <optional>
#include <string>
#include <utility>

#include "app/document/workspace.h"
#include "app/map/map_state.h"
#include "app/play/play_state.h"
#include "app/timeline/timeline.h"
#include "app/ui/ui.h"

namespace tact {

// At the end of a frame: a playing loop takes up this frame's edits without a restart, and a
// playing drive follows protection, full scale and calibration.
void hear_edits(Ui& ui, const Workspace& work, Timeline& timeline, PlayState& play);

// Also at the end of a frame: an item pressed for kHoldS repeats until the mouse is released.
void follow_hold(Ui& ui, Workspace& work, Timeline& timeline, PlayState& play);

// The two patterns of A|B, by name: those that play in turn, or those that would.
std::optional<std::pair<std::string, std::string>> alternating_pair(const Workspace& work,
                                                                    const ShownMap& shown_map,
                                                                    const PlayState& play);
// Makes the partner the current pattern, and the other way round; playing continues.
void swap_pair(Workspace& work, const ShownMap& shown_map, PlayState& play);

}  // namespace tact
