// The parameters of the model that agree best with what people said of sets, and where they come
// from. Window, command line and Python ask here.
//
// Source    model/training/training.h
// Input     sets with ratings; the model of before, whose other choices stay
// Output    the training, and the record that a file of parameters keeps
// Exact     same request, same bits, on any number of threads; but the record has the time.
#pragma once

#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "model/common/expected.h"
#include "model/io/set/model_file.h"
#include "model/perceptual_model/perceptual_model_params.h"
#include "model/set/pattern_set.h"
#include "model/study/ratings.h"
#include "model/training/training.h"

namespace tact {

// What is fitted without, each in turn, and tried on.
enum class LeaveOut { nothing, sets, participants, patterns };
inline constexpr const char* kLeaveOutNames[] = {"", "sets", "participants", "patterns"};

struct TrainRequest {
    std::vector<TrainingSet> sets;
    PerceptualModelParams model{};
    int units = 10;  // steps of a weight between 0 and 1: units_of_step()
    TrainingObjective objective = TrainingObjective::mean_rho;
    LeaveOut leave_out = LeaveOut::nothing;
    std::string program;  // with its version, for the record
    int threads = 0;      // 0: all cores
    std::stop_token stop{};
    std::function<void(double)> progress{};  // 0..1, from any thread
};

struct Trained {
    Training training;
    TrainingRecord record;
};

// The set's part of a request. `felt`: the patterns that the ratings are held against, in the
// order of the study's.
TrainingSet training_set(std::string name, const PatternSet& felt, RatingStudy study,
                         int threads = 0);

// Steps between 0 and 1 of this length. Errors: no whole number of them, or more than
// kMostTrainingUnits.
Expected<int> units_of_step(double step);

// Whether there is something to fit to. Errors: as can_train() of training.h; a single set, where
// sets are to be left out.
Expected<Done> can_train(const TrainRequest& request);

// Nothing when stopped. The request has to be such that can_train().
std::optional<Trained> train(const TrainRequest& request);

// What the command line prints and Python gives: {"objective", "step", "value", "value_before",
// "parameters", "parameters_before", "combinations", "equally_good", "equally_good_classes",
// "ties", "share_near_best", "near_best", "best_of", "synthetic", "sets": [{"name", "patterns",
// "rated_pairs", "participants", "synthetic", "unrated_patterns", "rho_before", "rho_after"}]},
// "without_set" of several sets, "without_participant" and "without_pattern" where that is asked
// for. null in "ties": any value will do.
nlohmann::json json_of(const Trained& trained, const TrainRequest& request);

}  // namespace tact
