#include "model/evaluation/metric_comparison.h"

#include <algorithm>
#include <cmath>

#include "model/set/pattern_set.h"

namespace tact {

namespace {

bool is_of_prediction(Metric metric) {
    return metric == Metric::pm || metric == Metric::nc || metric == Metric::oc;
}

bool is_simple(Metric metric) { return !is_of_prediction(metric) && metric != Metric::van_rossum; }

// The three that come out of one run, each with half of its cost spared twice.
std::optional<Prediction> prediction_for(std::span<const Metric> metrics,
                                         std::span<const Waveform> waveforms,
                                         const PerceptualModelParams& params,
                                         const MetricOptions& options) {
    if (std::ranges::none_of(metrics, is_of_prediction)) return Prediction{};
    PredictOptions run;
    run.threads = options.threads;
    run.stop = options.stop;
    return predict(waveforms, params, run);
}

std::optional<Dissimilarity> matrix_of(Metric metric, std::span<const Waveform> waveforms,
                                       const PerceptualModelParams& params,
                                       const Prediction& prediction, const MetricOptions& options) {
    if (metric == Metric::pm) return prediction.pm;
    if (metric == Metric::nc) return prediction.nc;
    if (metric == Metric::oc) return prediction.oc;
    std::optional<Dissimilarity> matrix = metric_matrix(metric, waveforms, params, options);
    if (matrix && metric == Metric::spqi) {
        matrix->condensed = average_ranks(values_to_rank(metric, *matrix, options.baseline));
    }
    return matrix;
}

}  // namespace

std::optional<std::vector<Dissimilarity>> compared_matrices(const PatternSet& set,
                                                            std::span<const Metric> metrics,
                                                            const Prediction* known,
                                                            const MetricOptions& options) {
    const std::vector<Waveform> waveforms = own_waveforms(set, options.threads);
    const auto computed = known == nullptr ? prediction_for(metrics, waveforms, set.model, options)
                                           : std::optional<Prediction>();
    if (known == nullptr && !computed) return std::nullopt;
    const Prediction& prediction = known == nullptr ? *computed : *known;
    std::vector<Dissimilarity> matrices;
    const auto count = static_cast<double>(metrics.size());
    for (const Metric metric : metrics) {
        MetricOptions one = options;
        one.progress = [&options, done = static_cast<double>(matrices.size()),
                        count](double share) {
            if (options.progress) options.progress((done + share) / count);
        };
        one.progress(0.0);
        auto matrix = matrix_of(metric, waveforms, set.model, prediction, one);
        if (!matrix || options.stop.stop_requested()) return std::nullopt;
        // Values that are printed alike count as equal in every table, map and rank.
        matrices.push_back(as_ranked(metric, *std::move(matrix)));
    }
    if (options.progress) options.progress(1.0);
    return matrices;
}

Expected<RatedPeople> rated_people(const RatingStudy& study, const EvaluationParams& params) {
    const Dissimilarity mean = mean_ratings(study);
    Expected<RatedSet> rated = rated_set(mean, params);
    if (!rated) return rated.error();
    const Reliability people = reliability(study);
    return RatedPeople{*std::move(rated),
                       people,
                       ceilings(study, people),
                       order_pairs(mean.condensed).ascending.size(),
                       participant_means(study).size(),
                       mark_of(study),
                       unrated_patterns(study),
                       study.edited,
                       study.gone};
}

namespace {

UncertaintyParams resampling_of(const EvaluationParams& params) {
    UncertaintyParams resampling;
    resampling.draws = params.bootstrap_draws;
    resampling.threads = params.threads;
    return resampling;
}

std::optional<std::vector<Evaluation>> without_intervals(
    std::span<const Dissimilarity> matrices, const RatedPeople& people,
    const EvaluationParams& params, const std::function<void(double)>& progress,
    const std::stop_token& stop) {
    std::vector<Evaluation> all;
    for (const Dissimilarity& matrix : matrices) {
        if (stop.stop_requested()) return std::nullopt;
        all.push_back(evaluate(matrix, people.rated, params));
        if (progress) {
            progress(static_cast<double>(all.size()) / static_cast<double>(matrices.size()));
        }
    }
    return all;
}

}  // namespace

std::optional<std::vector<Evaluation>> evaluations(std::span<const Dissimilarity> matrices,
                                                   const RatedPeople& people,
                                                   const EvaluationParams& params,
                                                   const std::function<void(double)>& progress,
                                                   std::stop_token stop) {
    auto all = without_intervals(matrices, people, params, progress, stop);
    if (!all) return std::nullopt;
    const auto intervals = rho_intervals(people.rated, matrices, *all, resampling_of(params));
    for (std::size_t m = 0; m < all->size(); ++m) (*all)[m].rho_interval = intervals[m];
    return all;
}

std::optional<MetricTable> metric_table(const RatingStudy& study, const RatedPeople& people,
                                        AgreementRequest request) {
    const std::vector<Metric>& metrics = request.metrics;
    const std::vector<Dissimilarity>& matrices = request.matrices;
    const EvaluationParams& params = request.params;
    const auto steps = static_cast<double>(matrices.size() + request.nuisances.size() + 2);
    double done = static_cast<double>(matrices.size());
    const auto is_stopped = [&] {
        if (request.progress) request.progress(++done / steps);
        return request.stop.stop_requested();
    };
    auto evaluated = without_intervals(
        matrices, people, params,
        [&](double share) {
            const auto evaluating = static_cast<double>(matrices.size());
            if (request.progress) request.progress(share * evaluating / steps);
        },
        request.stop);
    if (!evaluated) return std::nullopt;
    MetricTable table{metrics, {}, *std::move(evaluated), {}, {}, {}};
    table.individuals = individuals(study, people.rated, matrices, table.evaluations, params);
    if (is_stopped()) return std::nullopt;
    const auto pm = std::ranges::find(metrics, Metric::pm);
    std::optional<std::size_t> reference;
    if (pm != metrics.end()) reference = static_cast<std::size_t>(pm - metrics.begin());
    table.uncertainty = uncertainty(study, people.rated, matrices, table.evaluations, reference,
                                    resampling_of(params));
    for (std::size_t m = 0; m < table.evaluations.size(); ++m) {
        table.evaluations[m].rho_interval =
            table.uncertainty.rho[m].interval[static_cast<std::size_t>(Resampled::patterns)];
    }
    if (is_stopped()) return std::nullopt;
    BootstrapParams bootstrap;
    bootstrap.draws = params.bootstrap_draws;
    bootstrap.threads = params.threads;
    for (const Nuisance& one : request.nuisances) {
        table.given.push_back(
            given(one.name, one.apart, people.rated.people.dissimilarity, matrices, bootstrap));
        if (is_stopped()) return std::nullopt;
    }
    table.matrices = std::move(request.matrices);
    return table;
}

std::optional<Metric> unbeaten_by_pm(std::span<const MetricRho> agreements) {
    const MetricRho* pm = nullptr;
    const MetricRho* best = nullptr;
    for (const MetricRho& one : agreements) {
        if (one.metric == Metric::pm) pm = &one;
        if (!is_simple(one.metric) || std::isnan(one.rho)) continue;
        if (best == nullptr || one.rho > best->rho) best = &one;
    }
    if (pm == nullptr || best == nullptr || pm->rho > best->rho) return std::nullopt;
    return best->metric;
}

}  // namespace tact
