// The pane of the map: its controls, its headline, and what it says while there is no map.
#pragma once

#include <cstddef>
#include <string>

#include "app/document/workspace.h"
#include "app/map/map_look.h"
#include "app/map/map_state.h"
#include "app/map/space_scene.h"
#include "app/ui/ui.h"
#include "model/map/mds.h"

namespace tact {

SpacePaneAction draw_space_panel(Ui& ui, Workspace& work, ShownMap& shown_map,
                                 const MapMarks& marks);

// Why a map says little; empty: it says what it shows.
std::string verdict_text(const PerceptualSpace& space, std::size_t patterns);

}  // namespace tact
