// All metrics of a set against the same ratings: the paper's Table 2 for one's own set.
//
// Source    Lim & Park 2023, Table 2
// Input     a set, and ratings in the order of its patterns
// Exact     same input, same bits, on any number of threads.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "model/evaluation.h"
#include "model/metric_matrix.h"
#include "model/pattern_set.h"

namespace tact {

struct MetricAgreement {
    Metric metric = Metric::pm;
    Dissimilarity matrix;  // as evaluated: of SPQI the ranks, its values being too close to 1
    Evaluation evaluation;
};

// One row a metric, in their order; nothing when stopped. Progress counts metrics.
std::optional<std::vector<MetricAgreement>> compare_metrics(const PatternSet& set,
                                                            const RatedSet& rated,
                                                            std::span<const Metric> metrics,
                                                            const EvaluationParams& evaluation,
                                                            const MetricOptions& options = {});

// Without a model of the nerves, and no part of PM: what PM has to beat.
bool is_simple(Metric metric);

}  // namespace tact
