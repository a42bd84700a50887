// The pattern in the editor and the one closest to it: always in view, at the editor's foot.
#pragma once

#include <optional>

#include "app/document/workspace.h"
#include "app/map/map_state.h"
#include "app/ui/ui.h"

namespace tact {

// What was pressed on it, for the frame to do with the pattern in the editor and this one: places
// in the document.
enum class NeighbourDeed { play_both, why, separate };
struct NeighbourAction {
    NeighbourDeed deed;
    std::size_t neighbour = 0;
};

// What it takes of the pane; 0: there is none to show.
float neighbour_card_px(const Ui& ui, const Workspace& work, const ShownMap& shown_map);

std::optional<NeighbourAction> draw_neighbour_card(Ui& ui, Workspace& work,
                                                   const ShownMap& shown_map);

}  // namespace tact
