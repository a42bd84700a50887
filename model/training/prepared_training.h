// What the search for parameters needs of sets with ratings, and what it leaves to be said of each.
//
// Input     sets that can_train() takes
// Output    forms of spikes of every pair for all numbers of layers, ratings as columns, and an
//           objective each: of all sets, of all but one, of all participants but one
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "model/perceptual_model/perceptual_model.h"
#include "model/training/training.h"
#include "model/training/training_search.h"

namespace tact {

struct PreparedTraining {
    SearchProblem problem;
    std::vector<Prediction> before;
    std::vector<Dissimilarity> ratings;
    std::vector<std::string> left_out;  // participants, one objective each from `first_left_out` on
    std::size_t first_left_out = 0;
};

// Takes most of the time for a few patterns. `progress` goes from 0 to 1; nothing when stopped.
std::optional<PreparedTraining> prepared_training(std::span<const TrainingSet> sets,
                                                  const TrainingParams& params,
                                                  const std::function<void(double)>& progress);

// Every participant of any set, in the order in which they come.
std::vector<std::string> participants_of(std::span<const TrainingSet> sets);

// The study of one participant, or of all others.
RatingStudy part_of(const RatingStudy& study, const std::string& participant, bool others);

}  // namespace tact
