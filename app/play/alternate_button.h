// A|B in the transport bar: switches on that two patterns are felt in turn, and says which.
#pragma once

#include "app/document/workspace.h"
#include "app/map/map_state.h"
#include "app/play/play_state.h"
#include "app/ui/ui.h"

namespace tact {

// px; the same whatever the names are.
float alternate_width(const Ui& ui, bool names);

// `names`: with both patterns' marks and names, or dashes where there are not two.
void draw_alternate(Ui& ui, const Workspace& work, const ShownMap& shown_map, PlayState& play,
                    bool names);

}  // namespace tact
