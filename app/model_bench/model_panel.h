// The model bench: the parameters of PM, the knots of its tables, which parameters to have, and
// fitting them to ratings.
#pragma once

#include "app/window/app.h"

namespace tact {

void draw_model_panel(App& app);
void draw_table_fields(App& app, const PhysiologyTables& original);
void draw_model_choice(App& app);
void draw_training(App& app);

}  // namespace tact
