// Fitting the model's parameters to ratings from the window.
//
// Left out  drawing: app/panels/training_*.cpp.
#pragma once

#include "app/model_bench/training_state.h"
#include "app/window/app.h"

namespace tact {

void make_training_job(App& app);
void stop_training(App& app);

// What is shown of it, without its job: for a picture.
std::shared_ptr<TrainingState> still_training(const TrainingState& state);

// Takes what the job has found.
void follow_training(App& app);
bool is_training(const App& app);

// The document's ratings as a set to train on; where it has none that fit, why.
const OwnRatings& own_ratings(App& app);

// All sets that take part, the document first.
TrainingRequest training_request(App& app);
void begin_training(App& app);
void cancel_training(App& app);

// Whether the patterns, the ratings or the model's other choices have changed since.
bool is_training_stale(App& app);

// Sets with ratings of their own, from files.
void add_training_set_dialog(App& app);
void add_training_set(App& app, const std::filesystem::path& path);

// What was found becomes the document's model, as one step, and is kept
// (app/model_bench/kept_models.h).
void use_trained(App& app);
void save_trained_dialog(App& app);
void save_trained(App& app, const std::filesystem::path& path);

}  // namespace tact
