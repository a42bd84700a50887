// All metrics of a set against the same ratings: the paper's Table 2 for one's own set.
//
// Source    Lim & Park 2023, Table 2
// Input     a set, and ratings in the order of its patterns
// Exact     same input, same bits, on any number of threads.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <stop_token>
#include <string>
#include <vector>

#include "model/common/expected.h"
#include "model/evaluation/evaluation.h"
#include "model/evaluation/individuals.h"
#include "model/evaluation/metric_matrix.h"
#include "model/evaluation/nuisance.h"
#include "model/evaluation/uncertainty.h"
#include "model/perceptual_model/perceptual_model.h"
#include "model/set/pattern_set.h"
#include "model/study/ratings.h"

namespace tact {

// Their matrices as they are evaluated: of SPQI the ranks, its values being too close to 1. One a
// metric, in their order; nothing when stopped. `known`: what PM says of this set, where that is
// known. Progress is the share of the metrics.
std::optional<std::vector<Dissimilarity>> compared_matrices(const PatternSet& set,
                                                            std::span<const Metric> metrics,
                                                            const Prediction* known,
                                                            const MetricOptions& options = {});

// Those who rated, as one opinion to compare with, and how far they agree among themselves.
struct RatedPeople {
    RatedSet rated;
    Reliability reliability;
    Ceilings ceilings;
    std::size_t rated_pairs = 0;
    std::size_t participants = 0;
    NumberMark mark;
    std::vector<std::string> unrated;   // patterns that have no ratings and are left out
    std::vector<std::string> edited{};  // patterns that are others than were felt
    std::vector<std::string> gone{};    // rated, not in the set, and left out
};

// Errors: as rated_set().
Expected<RatedPeople> rated_people(const RatingStudy& study, const EvaluationParams& params);

// Each metric against the same people. The interval of a rho is over the pairs that all of these
// metrics know. `matrices`: as compared_matrices() has them, or of others. Progress is the share of
// the metrics; nothing when stopped.
std::optional<std::vector<Evaluation>> evaluations(std::span<const Dissimilarity> matrices,
                                                   const RatedPeople& people,
                                                   const EvaluationParams& params,
                                                   const std::function<void(double)>& progress = {},
                                                   std::stop_token stop = {});

// The same, with what people taken singly and other samples would say.
struct MetricTable {
    std::vector<Metric> metrics;
    std::vector<Dissimilarity> matrices;
    std::vector<Evaluation> evaluations;
    Individuals individuals;
    Uncertainty uncertainty;   // differences: from PM, where it is among the metrics
    std::vector<Given> given;  // in the order of the nuisances
};

struct Nuisance {
    std::string name;
    Dissimilarity apart;
};

struct AgreementRequest {
    std::vector<Metric> metrics;
    // Those of the metrics, as compared_matrices() has them, then those of others.
    std::vector<Dissimilarity> matrices;
    std::vector<Nuisance> nuisances{};
    EvaluationParams params{};
    std::stop_token stop{};
    std::function<void(double)> progress{};  // 0..1, from this thread
};

// Nothing when stopped.
std::optional<MetricTable> metric_table(const RatingStudy& study, const RatedPeople& people,
                                        AgreementRequest request);

struct MetricRho {
    Metric metric = Metric::pm;
    double rho = 0.0;  // NaN: undefined
};

// The best of the metrics without a model of the nerves that are no part of PM, where PM does not
// beat it.
std::optional<Metric> unbeaten_by_pm(std::span<const MetricRho> agreements);

}  // namespace tact
