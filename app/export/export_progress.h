// How far an animation is, at the lower right, over the panes: the window keeps working.
#pragma once

#include "app/export/export_state.h"
#include "app/ui/ui.h"

namespace tact {

void draw_export_progress(Ui& ui, ExportState& exports);

}  // namespace tact
