// The rows of the dialog for candidates: what every parameter may be, how many are made, and what
// they must keep to.
#pragma once

#include "app/generate/generate_state.h"
#include "app/ui/ui.h"

namespace tact {

void draw_factor_rows(Ui& ui, GenerateState& generating);
void draw_design_row(Ui& ui, GenerateState& generating);
void draw_constraint_rows(Ui& ui, GenerateState& generating);

}  // namespace tact
