// The actuator maps with which effects of other programs were read: a line above the list of
// patterns after opening some, and a dialog to read them with other maps.
//
// Left out  maps from files, which the command line's --actuator takes.
#pragma once

#include "app/document/workspace.h"
#include "app/ui/ui.h"

namespace tact {

void draw_effect_maps_line(Ui& ui, Workspace& work);
void draw_effect_maps_dialog(Ui& ui, Workspace& work);

}  // namespace tact
