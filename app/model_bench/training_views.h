// Parts of the view that trains the model.
#pragma once

#include "app/model_bench/training_state.h"
#include "app/window/app.h"

namespace tact {

// What was found, with what can be done with it.
void draw_training_result(App& app, const FoundTraining& found);

}  // namespace tact
