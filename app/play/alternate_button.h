// A|B in the transport bar: switches on that two patterns are felt in turn, and says which.
#pragma once

#include "app/document/workspace.h"
#include "app/map/map_state.h"
#include "app/play/play_state.h"
#include "app/ui/ui.h"

namespace tact {

struct AlternateWidths {
    float letters = 0.0F;     // px
    float with_names = 0.0F;  // as much where there are not two patterns
};
AlternateWidths alternate_widths(const Ui& ui, const Workspace& work, const ShownMap& shown_map,
                                 const PlayState& play);

// `names`: with both patterns' marks and names, where there are two.
void draw_alternate(Ui& ui, const Workspace& work, const ShownMap& shown_map, PlayState& play,
                    bool names);

}  // namespace tact
