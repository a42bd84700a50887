#include "app/live_comparison.h"

#include <algorithm>
#include <cmath>

#include "model/metric_comparison.h"
#include "model/set_ratings.h"

namespace tact {

namespace {

constexpr float kMatrixShare = 0.6F;  // of the progress bar

// Nothing for a metric that the map does not bring along.
std::optional<Dissimilarity> part_of(const Prediction& prediction, Metric metric) {
    if (metric == Metric::pm) return prediction.pm;
    if (metric == Metric::nc) return prediction.nc;
    if (metric == Metric::oc) return prediction.oc;
    return std::nullopt;
}

bool same_patterns(const PatternSet& a, const PatternSet& b) {
    return a.model == b.model && a.vibrations == b.vibrations;
}

PerceptualSpace space_of(const Dissimilarity& matrix, int dimensions, int threads,
                         std::stop_token stop) {
    MdsParams params = standard_mds_params(matrix.size, dimensions);
    params.threads = threads;
    return nonmetric_mds(matrix, params, stop);
}

// Who said something of this set; empty with a fault where nobody can be compared with.
std::optional<ComparedPeople> people_of(const LiveMap& map, const EvaluationParams& params,
                                        std::stop_token stop, std::string& fault) {
    const PatternSet& set = *map.request.set;
    if (set.ratings.empty()) return std::nullopt;
    const Expected<RatingStudy> study = study_of(set);
    if (!study) {
        fault = study.error().message;
        return std::nullopt;
    }
    const Dissimilarity mean = mean_ratings(*study);
    Expected<RatedSet> rated = rated_set(mean, params);
    if (!rated) {
        fault = rated.error().message;
        return std::nullopt;
    }
    ComparedPeople people{*std::move(rated), reliability(*study), 0, {}};
    people.rated_pairs = order_pairs(mean.condensed).ascending.size();
    const int dimensions = map.request.dimensions;
    people.shown = dimensions == params.dimensions
                       ? people.rated.people.space
                       : space_of(mean, dimensions, params.threads, stop);
    return people;
}

}  // namespace

// The matrices and maps of the patterns as they are; false when stopped.
bool ComparisonWork::follow_matrices(const ComparisonRequest& request, std::stop_token stop,
                                     std::atomic<float>& progress) {
    const PatternSet& set = *request.map->request.set;
    if (of_ && same_patterns(*of_->request.set, set)) return true;
    of_.reset();
    metrics_.clear();
    // Unpadded: DTW takes them as they are.
    std::vector<Waveform> waveforms;
    for (const Vibration& vibration : set.vibrations) waveforms.push_back(waveform_of(vibration));
    const Prediction& prediction = request.map->prediction;
    MetricOptions options;
    options.threads = threads_;
    options.stop = stop;
    for (std::size_t k = 0; k < kMetricCount; ++k) {
        const Metric metric = kMetrics[k];
        options.progress = [&progress, k](double share) {
            progress = kMatrixShare * (static_cast<float>(k) + static_cast<float>(share)) /
                       static_cast<float>(kMetricCount);
        };
        std::optional<Dissimilarity> matrix = part_of(prediction, metric);
        if (!matrix) {
            matrix = metric_matrix(metric, waveforms, set.model, options);
            if (!matrix || stop.stop_requested()) return false;
            matrix->condensed = values_to_rank(metric, *matrix);
        }
        ComparedMetric compared{metric, *std::move(matrix), {}, 0.0, {}};
        compared.space = space_of(compared.matrix, 3, threads_, stop);
        compared.rho_with_pm = spearman(compared.matrix.condensed, prediction.pm.condensed);
        if (stop.stop_requested()) return false;
        metrics_.push_back(std::move(compared));
    }
    of_ = request.map;
    return true;
}

std::optional<Comparison> ComparisonWork::operator()(const ComparisonRequest& request,
                                                     std::stop_token stop,
                                                     std::atomic<float>& progress) {
    if (!follow_matrices(request, stop, progress)) return std::nullopt;
    progress = kMatrixShare;
    EvaluationParams params;
    params.threads = threads_;
    Comparison comparison{request, {}, {}, metrics_};
    comparison.people = people_of(*request.map, params, stop, comparison.fault);
    if (!comparison.people) return comparison;
    for (std::size_t k = 0; k < kMetricCount; ++k) {
        if (stop.stop_requested()) return std::nullopt;
        ComparedMetric& metric = comparison.metrics[k];
        metric.evaluation = evaluate(metric.matrix, comparison.people->rated, params);
        progress = kMatrixShare + (1.0F - kMatrixShare) * static_cast<float>(k + 1) /
                                      static_cast<float>(kMetricCount);
    }
    return comparison;
}

std::string verdict_on_pm(const Comparison& comparison) {
    const ComparedMetric* best = nullptr;
    double pm = std::nan("");
    for (const ComparedMetric& row : comparison.metrics) {
        if (!row.evaluation) return {};
        if (row.metric == Metric::pm) pm = row.evaluation->rho;
        const double rho = row.evaluation->rho;
        const bool counts = is_simple(row.metric) && !std::isnan(rho);
        if (counts && (best == nullptr || rho > best->evaluation->rho)) best = &row;
    }
    if (best == nullptr || pm > best->evaluation->rho) return {};
    return std::string("PM does not beat ") + traits(best->metric).name +
           " on this set, which takes no model of the nerves.";
}

std::vector<Disagreement> disagreements(const Dissimilarity& metric, const Dissimilarity& ratings) {
    std::vector<std::size_t> pairs;
    std::vector<double> predicted;
    std::vector<double> said;
    for (std::size_t k = 0; k < ratings.condensed.size(); ++k) {
        if (!std::isfinite(ratings.condensed[k]) || !std::isfinite(metric.condensed[k])) continue;
        pairs.push_back(k);
        predicted.push_back(metric.condensed[k]);
        said.push_back(ratings.condensed[k]);
    }
    const std::vector<double> metric_rank = average_ranks(predicted);
    const std::vector<double> ratings_rank = average_ranks(said);
    std::vector<Disagreement> all;
    for (std::size_t k = 0; k < pairs.size(); ++k) {
        all.push_back({pairs[k], metric_rank[k], ratings_rank[k]});
    }
    std::ranges::stable_sort(all, std::ranges::greater{}, [](const Disagreement& d) {
        return std::abs(d.metric_rank - d.ratings_rank);
    });
    return all;
}

}  // namespace tact
