// Fitting the model's parameters to ratings from the window.
//
// Left out  drawing: app/model_bench/training_panel.cpp.
#pragma once

#include "app/document/workspace.h"
#include "app/model_bench/model_state.h"
#include "app/model_bench/training_state.h"
#include "app/ui/ui.h"

namespace tact {

// Takes what the job has found.
void follow_training(Ui& ui, ModelBench& model_bench);
bool is_training(const ModelBench& model_bench);

// The document's ratings as a set to train on; where it has none that fit, why.
const OwnRatings& own_ratings(const Workspace& work, ModelBench& model_bench);

// All sets that take part, the document first.
TrainingRequest training_request(const Workspace& work, ModelBench& model_bench);
void begin_training(const Ui& ui, const Workspace& work, ModelBench& model_bench);
void cancel_training(ModelBench& model_bench);

// Whether the patterns, the ratings or the model's other choices have changed since.
bool is_training_stale(const Workspace& work, ModelBench& model_bench);

// Sets with ratings of their own, from files.
void add_training_set_dialog(Ui& ui, const Workspace& work);
void add_training_set(Ui& ui, const Workspace& work, ModelBench& model_bench,
                      const std::filesystem::path& path);

// What was found becomes the document's model, as one step, and is kept
// (app/model_bench/kept_models.h).
void use_trained(Ui& ui, Workspace& work, ModelBench& model_bench);
void save_trained_dialog(Ui& ui, const Workspace& work, const ModelBench& model_bench);
void save_trained(Ui& ui, const ModelBench& model_bench, const std::filesystem::path& path);

}  // namespace tact
