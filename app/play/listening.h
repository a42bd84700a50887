// Heard while one works: edits of what sounds, what the mouse is pressed on, and two in turn.
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

// At the end of a frame: a loop of the pattern in the editor becomes what was made of that in this
// frame, without starting anew; and what sounds follows protection, full scale and calibration.
void hear_edits(Ui& ui, const Workspace& work, Timeline& timeline, PlayState& play);

// At the end of a frame, too: what the mouse has been pressed on for kHoldS sounds over and over,
// until it is let go.
void follow_hold(Ui& ui, Workspace& work, Timeline& timeline, PlayState& play);

// The two that A|B plays, by name: those that sound in turn, else those that would.
std::optional<std::pair<std::string, std::string>> alternating_pair(const Workspace& work,
                                                                    const ShownMap& shown_map,
                                                                    const PlayState& play);
// The partner becomes the current one, and that its partner; what sounds goes on.
void swap_pair(Workspace& work, const ShownMap& shown_map, PlayState& play);

}  // namespace tact
