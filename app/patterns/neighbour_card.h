// The pattern in the editor and its closest neighbour: always visible, at the bottom of a narrow
// editor and in the first line of a wide one.
#pragma once

#include <optional>

#include "app/document/workspace.h"
#include "app/map/map_state.h"
#include "app/ui/ui.h"

namespace tact {

// Buttons pressed on the card, and the place of the neighbour in the document.
enum class NeighbourChoice { play_both, why, separate };
struct NeighbourAction {
    NeighbourChoice action;
    std::size_t neighbour = 0;
};

// Rows of the map on screen, and the closest one's place in the document. Computed once a frame.
struct Neighbour {
    std::size_t own = 0;
    std::size_t closest = 0;
    std::size_t place = 0;
};
std::optional<Neighbour> neighbour_of(const Workspace& work, const ShownMap& shown_map);

// Height of the card in the pane.
float neighbour_card_px(const Ui& ui, const Workspace& work, const ShownMap& shown_map,
                        const Neighbour& pair);

std::optional<NeighbourAction> draw_neighbour_card(Ui& ui, Workspace& work,
                                                   const ShownMap& shown_map,
                                                   const Neighbour& pair);

}  // namespace tact
