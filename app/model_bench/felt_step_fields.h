// The least change of each number that people are taken to feel: rows of the model bench.
#pragma once

#include "app/document/workspace.h"
#include "app/ui/ui.h"

namespace tact {

void draw_felt_step_fields(Ui& ui, Workspace& work);

}  // namespace tact
