#include "model/metric_comparison.h"

#include <algorithm>

#include "model/perceptual_model.h"

namespace tact {

namespace {

bool is_of_prediction(Metric metric) {
    return metric == Metric::pm || metric == Metric::nc || metric == Metric::oc;
}

// The three that come out of one run, each with half of its cost spared twice.
std::optional<Prediction> prediction_for(const PatternSet& set, std::span<const Metric> metrics,
                                         const MetricOptions& options) {
    if (std::ranges::none_of(metrics, is_of_prediction)) return Prediction{};
    PredictOptions run;
    run.threads = options.threads;
    run.stop = options.stop;
    return predict(model_waveforms(set), set.model, run);
}

std::optional<Dissimilarity> matrix_of(Metric metric, std::span<const Waveform> waveforms,
                                       const PerceptualModelParams& params,
                                       const Prediction& prediction, MetricOptions options) {
    if (metric == Metric::pm) return prediction.pm;
    if (metric == Metric::nc) return prediction.nc;
    if (metric == Metric::oc) return prediction.oc;
    options.progress = {};
    std::optional<Dissimilarity> matrix = metric_matrix(metric, waveforms, params, options);
    if (matrix && metric == Metric::spqi) {
        matrix->condensed = average_ranks(values_to_rank(metric, *matrix, options.baseline));
    }
    return matrix;
}

}  // namespace

bool is_simple(Metric metric) {
    return metric != Metric::pm && metric != Metric::nc && metric != Metric::oc &&
           metric != Metric::van_rossum;
}

std::optional<std::vector<MetricAgreement>> compare_metrics(const PatternSet& set,
                                                            const RatedSet& rated,
                                                            std::span<const Metric> metrics,
                                                            const EvaluationParams& evaluation,
                                                            const MetricOptions& options) {
    const auto prediction = prediction_for(set, metrics, options);
    if (!prediction) return std::nullopt;
    // DTW takes them as they are; the others pad.
    std::vector<Waveform> waveforms;
    for (const Vibration& vibration : set.vibrations) waveforms.push_back(waveform_of(vibration));
    std::vector<MetricAgreement> rows;
    for (const Metric metric : metrics) {
        if (options.progress) {
            options.progress(static_cast<double>(rows.size()) /
                             static_cast<double>(metrics.size()));
        }
        auto matrix = matrix_of(metric, waveforms, set.model, *prediction, options);
        if (!matrix || options.stop.stop_requested()) return std::nullopt;
        Evaluation agreement = evaluate(*matrix, rated, evaluation);
        rows.push_back({metric, *std::move(matrix), std::move(agreement)});
    }
    if (options.progress) options.progress(1.0);
    return rows;
}

}  // namespace tact
