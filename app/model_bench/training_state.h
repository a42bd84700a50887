// Training in the model bench: what it is asked to fit to, and what it has found.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/jobs/query.h"
#include "model/io/set/model_file.h"
#include "model/set/pattern_set.h"
#include "model/study/ratings.h"
#include "model/training/training.h"

namespace tact {

// A set with ratings that takes part, or could.
struct SetToFit {
    std::string name;
    std::shared_ptr<const PatternSet> set;     // only patterns that were rated
    std::shared_ptr<const RatingStudy> study;  // in their order
    std::size_t people = 0;
    std::filesystem::path file;  // empty: the document
    bool takes_part = true;
};

struct TrainingRequest {
    std::vector<SetToFit> sets;
    PerceptualModelParams model;
    int units = 10;
    TrainingObjective objective = TrainingObjective::mean_rho;
    bool leave_out_participants = false;
};

struct FoundTraining {
    TrainingRequest request;
    std::string fault;  // why there is nothing to fit to; then there is no training
    Training training;
    TrainingRecord record;
};

// Parameters kept in the folder of models, or the paper's.
struct KeptModel {
    std::string name;
    std::filesystem::path file;
    ModelFile content;
};

// The document's part of the request, kept while the document stays.
struct OwnRatings {
    std::uint64_t revision = 0;  // of the document; 0: none known yet
    std::optional<SetToFit> set;
    std::string fault;  // why it is missing
};

// Whether the result is of the present sets that take part, kept while all of that stays.
struct TrainingFreshness {
    std::shared_ptr<const FoundTraining> of;
    std::uint64_t revision = 0;  // of the document
    std::vector<std::shared_ptr<const PatternSet>> sets;
    bool is_stale = false;
};

// What the search would cost, kept while the question stays.
struct TrainingEstimate {
    std::vector<std::size_t> patterns;  // of each set
    int units = 0;
    TrainingCost cost;
};

struct TrainingState {
    int units = 10;  // steps of a weight between 0 and 1
    TrainingObjective objective = TrainingObjective::mean_rho;
    bool leave_out_participants = false;
    bool own_takes_part = true;
    std::vector<SetToFit> others;  // from files
    bool shows_ties = false;
    bool scroll_to_result = false;  // it has just come

    OwnRatings own;
    TrainingFreshness freshness;
    TrainingEstimate estimate;
    std::vector<KeptModel> kept;  // by name
    bool kept_were_read = false;

    Query<TrainingRequest, FoundTraining> job;
    std::shared_ptr<const FoundTraining> found;
};

}  // namespace tact
