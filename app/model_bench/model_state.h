// Which part of the model the bench shows.
#pragma once

#include "app/model_bench/training_state.h"
#include "model/physiology/mechanoreceptor.h"

namespace tact {

enum class ModelView { parameters, training };

// Which view of the model bench is shown, and whose knots it lists.
struct ModelPanelState {
    ModelView view = ModelView::parameters;
    Receptor type = Receptor::pacinian;
    bool threshold = true;  // or slope
};

struct ModelBench {
    ModelPanelState panel;
    TrainingState training;
};

}  // namespace tact
