// The editor of the selected patterns.
#pragma once

#include <functional>
#include <optional>

#include "app/document/workspace.h"
#include "app/map/map_state.h"
#include "app/patterns/neighbour_card.h"
#include "app/patterns/patterns_state.h"
#include "app/timeline/timeline.h"
#include "app/ui/ui.h"

namespace tact {

// Drawn below the strip in a wide and high pane; may be empty.
using DrawFoot = std::function<void()>;

// Returns what was pressed on the card of the closest neighbour.
std::optional<NeighbourAction> draw_editor_panel(Ui& ui, Workspace& work,
                                                 PatternPanes& pattern_panes, Timeline& timeline,
                                                 const ShownMap& shown_map,
                                                 const DrawFoot& draw_foot);

}  // namespace tact
