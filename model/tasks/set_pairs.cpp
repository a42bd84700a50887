#include "model/tasks/set_pairs.h"

#include <memory>
#include <utility>

#include "model/set/pattern_set.h"

namespace tact {

namespace {

using Codes = std::vector<std::shared_ptr<const PatternCode>>;

bool is_of_codes(Metric metric) { return metric == Metric::pm || metric == Metric::nc; }

PredictOptions prediction_options(const MetricOptions& options) {
    PredictOptions how;
    how.threads = options.threads;
    how.stop = options.stop;
    how.progress = options.progress;
    return how;
}

std::optional<Dissimilarity> known_pairs(Metric metric, const Prediction* known) {
    if (known == nullptr) return std::nullopt;
    if (metric == Metric::pm) return known->pm;
    if (metric == Metric::nc) return known->nc;
    if (metric == Metric::oc) return known->oc;
    return std::nullopt;
}

// By the codes where there are any, so that nothing is coded twice.
std::optional<Dissimilarity> pairs_of(const Codes& codes, std::span<const Waveform> felt,
                                      const PerceptualModelParams& model,
                                      const PairsRequest& request) {
    const PredictOptions how = prediction_options(request.options);
    if (request.metric == Metric::pm) {
        auto prediction = predict(codes, model, how);
        return prediction ? std::optional(std::move(prediction->pm)) : std::nullopt;
    }
    if (request.metric == Metric::nc) return nc_matrix(codes, model, how);
    if (request.metric == Metric::oc && !codes.empty()) return oc_matrix(codes, model, how);
    return metric_matrix(request.metric, felt, model, request.options);
}

}  // namespace

std::optional<SetPairs> set_pairs(std::span<const Waveform> felt,
                                  const PerceptualModelParams& model, const PairsRequest& request) {
    std::optional<Dissimilarity> apart = known_pairs(request.metric, request.known);
    Codes codes;
    if (request.known != nullptr) {
        codes = request.known->codes;
    } else if (request.with_unfelt || is_of_codes(request.metric)) {
        codes = pattern_codes(felt, model, prediction_options(request.options));
        if (codes.size() != felt.size()) return std::nullopt;
    }
    if (!apart) apart = pairs_of(codes, felt, model, request);
    if (!apart || request.options.stop.stop_requested()) return std::nullopt;
    return SetPairs{
        as_ranked(request.metric, *std::move(apart), request.options.baseline),
        request.with_unfelt ? unfelt(codes) : std::vector<std::size_t>(),
    };
}

std::optional<SetPairs> set_pairs(const PatternSet& felt, const PairsRequest& request) {
    const bool is_known = known_pairs(request.metric, request.known).has_value();
    const auto waveforms =
        is_known ? std::vector<Waveform>() : own_waveforms(felt, request.options.threads);
    return set_pairs(waveforms, felt.model, request);
}

std::optional<std::vector<std::size_t>> unfelt_in(std::span<const Waveform> felt,
                                                  const PerceptualModelParams& model, int threads,
                                                  std::stop_token stop) {
    PredictOptions how;
    how.threads = threads;
    how.stop = stop;
    const Codes codes = pattern_codes(felt, model, how);
    if (codes.size() != felt.size()) return std::nullopt;
    return unfelt(codes);
}

std::optional<std::vector<std::size_t>> unfelt_in(const PatternSet& felt, int threads,
                                                  std::stop_token stop) {
    return unfelt_in(own_waveforms(felt, threads), felt.model, threads, std::move(stop));
}

}  // namespace tact
