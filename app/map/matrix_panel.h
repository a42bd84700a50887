// The dissimilarity of every pair.
#pragma once

#include "app/document/workspace.h"
#include "app/map/map_state.h"
#include "app/ui/ui.h"

namespace tact {

void draw_matrix_panel(Ui& ui, Workspace& work, ShownMap& shown_map);

}  // namespace tact
