// Over the window: which candidates to generate.
#pragma once

#include "app/document/workspace.h"
#include "app/generate/generate_state.h"
#include "app/ui/ui.h"

namespace tact {

void draw_generate_dialog(Ui& ui, Workspace& work, GenerateState& generating);

}  // namespace tact
