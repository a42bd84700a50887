// Fitting the eight trained parameters to what people said of one's own sets.
//
// Searches the whole grid (training_search.h), and says what a fit is worth: how flat the optimum
// is, how it does on each set, and how on a set or a person that it has not seen.
//
// Source    Lim & Park 2023, sections 4.3, 5.3: the grid, and the mean of Spearman's rho over sets.
//           Ties [ours]: the combination nearest to the parameters before, in steps of the grid,
//           then the first.
// Input     sets with ratings; the model's other choices, which stay
// Output    see Training
// Valid     L_E, L_I 0 to 4, weights 0 to 1 by equal steps
// Left out  a search between the steps; regularisation.
// Exact     same input, same bits, on any number of threads and any instruction set.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <stop_token>
#include <string>
#include <vector>

#include "model/common/expected.h"
#include "model/perceptual_model/perceptual_model_params.h"
#include "model/signal/waveform.h"
#include "model/study/ratings.h"
#include "model/training/training_search.h"

namespace tact {

// A set with what people said of it, in the order of its patterns.
struct TrainingSet {
    std::string name;
    std::vector<Waveform> waveforms;  // at 10 kHz; zeros follow, up to the longest
    RatingStudy study;
};

struct TrainingParams {
    PerceptualModelParams model{};  // before; its choices stay
    int units = 10;                 // steps of a weight between 0 and 1
    TrainingObjective objective = TrainingObjective::mean_rho;
    bool leave_out_participants = false;
    bool leave_out_patterns = false;         // each with all its pairs
    int threads = 0;                         // 0: all cores
    const TrainingKernel* kernel = nullptr;  // null: the one in use
    std::stop_token stop{};
    std::function<void(double)> progress{};  // share of the work done, 0..1, from any thread
};

inline constexpr std::size_t kTrainedParameters = 8;
// L_E, L_I, the four channels' weights, w_NC, w_OC.
inline constexpr std::array<const char*, kTrainedParameters> kTrainedNames{
    "L_E", "L_I", "w_FA1", "w_FA2", "w_SA1", "w_SA2", "w_NC", "w_OC"};

std::array<double, kTrainedParameters> trained_values(const PerceptualModelParams& model);

struct TrainedSet {
    std::string name;
    std::size_t patterns = 0;
    std::size_t rated_pairs = 0;
    double rho_before = 0.0;
    double rho_after = 0.0;
};

// Fitted without a set, a participant or a pattern, and tried on just that: a participant on
// vibrations that the fit has seen, a pattern on its pairs with such. Rhos are means over the sets
// that the left out took part in; NaN: what was left out has no order of its own.
struct LeftOut {
    std::string name;
    PerceptualModelParams model;
    double value = 0.0;              // of the objective over the rest
    std::uint64_t combinations = 0;  // equally good ones
    double rho_before = 0.0;         // of the left out
    double rho_after = 0.0;
};

// Means over those of which both rhos are known; NaN of none.
struct LeftOutMean {
    double rho_before = 0.0;
    double rho_after = 0.0;
};
LeftOutMean mean_of(std::span<const LeftOut> left_out);

struct Training {
    TrainingObjective objective = TrainingObjective::mean_rho;
    PerceptualModelParams before;
    PerceptualModelParams model;  // the chosen one of the best
    double value_before = 0.0;    // of the objective
    SearchOptimum best;
    TrainingGrid grid;
    double share_near_best = 0.0;  // of all combinations, at most kNearBest below
    // Best of the objective for each value of a parameter, 0 to 4 layers or a weight by steps.
    std::array<std::vector<double>, kTrainedParameters> best_of;
    std::vector<TrainedSet> sets;
    std::vector<LeftOut> without_set;          // each, if there are several
    std::vector<LeftOut> without_participant;  // each, if asked for
    std::vector<LeftOut> without_pattern;      // the same
};

// Finer steps would take days.
inline constexpr int kMostTrainingUnits = 40;

inline constexpr double kNearBest = 0.01;

// Whether there is something to fit to. Errors: no set; a set with fewer than three patterns or
// without order in its ratings; to leave participants out, fewer than two.
Expected<Done> can_train(std::span<const TrainingSet> sets, const TrainingParams& params);

// Nothing when stopped. The sets have to be such that can_train().
std::optional<Training> train(std::span<const TrainingSet> sets, const TrainingParams& params);

// How many combinations a search ranks, and roughly how long that takes on one core.
struct TrainingCost {
    std::uint64_t combinations = 0;  // of the grid
    std::uint64_t different = 0;     // not in proportion to another
    double one_core_s = 0.0;
};
TrainingCost training_cost(std::span<const std::size_t> patterns_of_sets, int units);

}  // namespace tact
