// Keeping the stages on screen in step with the current and the pinned pattern.
#pragma once

#include "app/document/workspace.h"
#include "app/map/map_state.h"
#include "app/physiology/physiology_state.h"
#include "app/rendering/rendering_state.h"
#include "app/ui/ui.h"

namespace tact {

void take_stages(Physiology& physiology);

// Asks for the stages of the current and of the pinned vibration where they are not those that were
// asked for last.
void follow_current(const Ui& ui, Workspace& work, const RenderingState& rendered,
                    Physiology& physiology);

// How far the rhythms of the two are apart, as the map beside them has it.
void follow_pair(const Workspace& work, const ShownMap& shown_map, Physiology& physiology);

}  // namespace tact
