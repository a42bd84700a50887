// The row above the map while a pattern is varied, or searched for a place.
#pragma once

#include "app/ask/proposals_state.h"
#include "app/document/workspace.h"
#include "app/ui/ui.h"

namespace tact {

void draw_vary_bar(Ui& ui, const Workspace& work, ProposalsState& state);

}  // namespace tact
