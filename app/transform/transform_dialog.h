// The dialog for edits of the selected patterns: stretch, reverse, join and so on.
#pragma once

#include "app/document/workspace.h"
#include "app/transform/transform_state.h"
#include "app/ui/ui.h"

namespace tact {

// Enter applies the edit, Esc closes the dialog and changes nothing.
void draw_transform_dialog(Ui& ui, Workspace& work, TransformState& state);

}  // namespace tact
