// The rows of the dialog for candidates: what every parameter may be, how many are made, and what
// they must keep to.
#pragma once

#include "app/window/app.h"

namespace tact {

void draw_factor_rows(App& app);
void draw_design_row(App& app);
void draw_constraint_rows(App& app);

}  // namespace tact
