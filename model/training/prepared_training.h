// What the search for parameters needs of sets with ratings, and what it leaves to be said of each.
//
// Input     sets that can_train() takes
// Output    forms of spikes of every pair for all numbers of layers, ratings as columns, and an
//           objective each: of all sets, of all but one, and of all ratings but those left out
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

// Ratings that an objective does without, and that its optimum is tried on.
struct LeftOutRatings {
    std::string name;
    std::size_t objective = 0;                 // its place
    std::vector<std::vector<double>> ratings;  // condensed, of every set; empty: none of it
};

struct PreparedTraining {
    SearchProblem problem;
    std::vector<Prediction> before;
    std::vector<Dissimilarity> ratings;
    std::vector<LeftOutRatings> participants;
    std::vector<LeftOutRatings> patterns;
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
