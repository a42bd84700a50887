// A|B in the transport bar: plays two patterns in turn, and names them.
#pragma once

#include "app/document/workspace.h"
#include "app/map/map_state.h"
#include "app/play/play_state.h"
#include "app/ui/ui.h"

namespace tact {

// In px; does not depend on the names.
float alternate_width(const Ui& ui, bool names);

// `names`: shows both patterns' marks and names, or dashes if there are fewer than two.
void draw_alternate(Ui& ui, const Workspace& work, const ShownMap& shown_map, PlayState& play,
                    bool names);

}  // namespace tact
