// Parts of the view that trains the model.
#pragma once

#include "app/document/workspace.h"
#include "app/model_bench/model_state.h"
#include "app/model_bench/training_state.h"
#include "app/ui/ui.h"

namespace tact {

// What was found, with what can be done with it.
void draw_training_result(Ui& ui, Workspace& work, ModelBench& model_bench,
                          const FoundTraining& found);

}  // namespace tact
