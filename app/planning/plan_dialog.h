// The dialog on a study's plan.
#pragma once

#include "app/document/workspace.h"
#include "app/planning/plan_state.h"
#include "app/ui/ui.h"

namespace tact {

void draw_plan_dialog(Ui& ui, Workspace& work, PlanState& planning);

}  // namespace tact
