// The most distinct patterns, those that are too close, and how sure that is.
#pragma once

#include "app/document/workspace.h"
#include "app/map/map_state.h"
#include "app/patterns/pattern_menu.h"
#include "app/play/play_state.h"
#include "app/subset/subset_state.h"
#include "app/timeline/timeline.h"
#include "app/ui/ui.h"

namespace tact {

// What was asked for in the menu of a member is for the frame.
PatternAction draw_subset_panel(Ui& ui, Workspace& work, Timeline& timeline,
                                const ShownMap& shown_map, PlayState& play, SubsetState& picking);

}  // namespace tact
