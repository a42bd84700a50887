// The actuator maps by which effects of other programs were read: a line above the list of patterns
// where some were just opened, and a dialog to read them by others.
//
// Left out  maps from files, which the command line's --actuator takes.
#pragma once

#include "app/document/workspace.h"
#include "app/ui/ui.h"

namespace tact {

void draw_effect_maps_line(Ui& ui, Workspace& work);
void draw_effect_maps_dialog(Ui& ui, Workspace& work);

}  // namespace tact
