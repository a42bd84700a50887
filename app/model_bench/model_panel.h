// The model bench: the parameters of PM, the knots of its tables, which parameters to have, and
// fitting them to ratings.
#pragma once

#include <string>

#include "app/document/workspace.h"
#include "app/model_bench/model_state.h"
#include "app/ui/ui.h"

namespace tact {

void draw_model_panel(Ui& ui, Workspace& work, ModelBench& model_bench);
// How deaf each receptor type is, as a whole.
void draw_threshold_knobs(Ui& ui, Workspace& work, const PerReceptor<Curve>& original);
void draw_table_fields(Ui& ui, Workspace& work, ModelBench& model_bench,
                       const PhysiologyTables& original);
void draw_model_choice(Ui& ui, Workspace& work, ModelBench& model_bench);
void draw_training(Ui& ui, Workspace& work, ModelBench& model_bench);

// What every field of the bench leaves free at its right, so that all end alike.
float beside_field_px(const Ui& ui);
// In that room, on the line of the entry of the field drawn last, as a group. True when pressed.
bool link_beside_field(const Ui& ui, const char* id, const std::string& of,
                       const std::string& text);

}  // namespace tact
