#include "app/compare/compare.h"

#include <algorithm>
#include <cmath>

#include "app/rendering/rendering.h"
#include "model/io/tables/matrix_file.h"
#include "model/perceptual_model/rhythm_envelope.h"
#include "model/physiology/spike_train.h"
#include "model/tasks/set_people.h"
#include "model/text/numbers.h"

namespace tact {

namespace {

// Shares of the progress bar at which matrices and maps are done.
constexpr float kMatrixShare = 0.5F;
constexpr float kMapShare = 0.6F;

constexpr std::size_t kFarthest = 10;

// Share of the progress bar at which this metric is done.
float part_done(std::size_t k) {
    return static_cast<float>(k + 1) / static_cast<float>(kMetricCount);
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

// The raters of this set; empty, with a fault, if there is no one to compare with.
std::optional<ComparedPeople> people_of(const LiveMap& map, const EvaluationParams& params,
                                        std::stop_token stop, std::string& fault) {
    const PatternSet& set = *map.request.set;
    if (set.ratings.empty()) return std::nullopt;
    const Expected<Counted> counted = set_people(set);
    if (!counted) {
        fault = counted.error().message;
        return std::nullopt;
    }
    Expected<RatedPeople> said = rated_people(counted->study, params);
    if (!said) {
        fault = said.error().message;
        return std::nullopt;
    }
    ComparedPeople people{*std::move(said), {}};
    const Mapped& mean = rated_part(people.said.rated).people;
    const int dimensions = map.request.dimensions;
    people.shown = dimensions == params.dimensions
                       ? mean.space
                       : space_of(mean.dissimilarity, dimensions, params.threads, stop);
    return people;
}

}  // namespace

void ComparisonWork::add_row(ComparedMetric row, Dissimilarity matrix, const Prediction& prediction,
                             std::stop_token stop) {
    row.matrix = std::move(matrix);
    row.ranks = average_ranks(row.matrix.condensed);
    row.space = space_of(row.matrix, 3, threads_, std::move(stop));
    row.rho_with_pm = spearman(row.matrix.condensed, prediction.pm.condensed);
    metrics_.push_back(std::move(row));
}

// Matrices and maps of the current patterns; false when stopped.
bool ComparisonWork::follow_matrices(const ComparisonRequest& request, std::stop_token stop,
                                     std::atomic<float>& progress) {
    const PatternSet& set = *request.map->played;
    const bool same = of_ && same_patterns(*of_->played, set);
    if (same && foreign_ == request.foreign) return true;
    const Prediction& prediction = request.map->prediction;
    of_.reset();
    failed_.clear();
    if (!same || metrics_.size() < kMetricCount) {
        metrics_.clear();
        MetricOptions options;
        options.threads = threads_;
        options.stop = stop;
        options.progress = [&progress](double share) {
            progress = kMatrixShare * static_cast<float>(share);
        };
        auto matrices = compared_matrices(set, kMetrics, &prediction, options);
        if (!matrices) return false;
        for (std::size_t k = 0; k < kMetricCount; ++k) {
            const MetricTraits& about = traits(kMetrics[k]);
            ComparedMetric row;
            row.metric = kMetrics[k];
            row.key = about.key;
            row.name = about.name;
            row.help =
                std::string(about.name) + ": " + about.description + ". " + about.source + ".";
            add_row(std::move(row), std::move((*matrices)[k]), prediction, stop);
            if (stop.stop_requested()) return false;
            progress = kMatrixShare + (kMapShare - kMatrixShare) * part_done(k);
        }
    }
    metrics_.resize(kMetricCount);
    for (const ForeignMetric& one : request.foreign) {
        Expected<Dissimilarity> matrix = foreign_matrix(one.from, set, {.stop = stop});
        if (stop.stop_requested()) return false;
        if (!matrix) {
            failed_.push_back(matrix.error().message);
            continue;
        }
        ComparedMetric row;
        row.key = row.name = one.key;
        row.help = "A metric of your own, from " + one.from + ".";
        add_row(std::move(row), *std::move(matrix), prediction, stop);
    }
    foreign_ = request.foreign;
    of_ = request.map;
    return true;
}

std::optional<Comparison> ComparisonWork::operator()(const ComparisonRequest& request,
                                                     std::stop_token stop,
                                                     std::atomic<float>& progress) {
    if (!follow_matrices(request, stop, progress)) return std::nullopt;
    progress = kMapShare;
    EvaluationParams params;
    params.threads = threads_;
    Comparison comparison{request, {}, {}, metrics_, failed_};
    comparison.people = people_of(*request.map, params, stop, comparison.fault);
    if (!comparison.people) return comparison;
    const RatedPeople& said = comparison.people->said;
    std::vector<Dissimilarity> matrices;
    for (const ComparedMetric& metric : comparison.metrics) matrices.push_back(metric.matrix);
    auto evaluated = evaluations(
        matrices, said, params,
        [&progress](double share) {
            progress = kMapShare + (1.0F - kMapShare) * static_cast<float>(share);
        },
        stop);
    if (!evaluated) return std::nullopt;
    for (std::size_t k = 0; k < comparison.metrics.size(); ++k) {
        ComparedMetric& metric = comparison.metrics[k];
        metric.evaluation = std::move((*evaluated)[k]);
        metric.farthest = disagreements(metric.matrix, said.rated.people.dissimilarity);
        metric.farthest.resize(std::min(metric.farthest.size(), kFarthest));
    }
    return comparison;
}

const ComparedMetric& metric_of_key(const Comparison& comparison, const std::string& key) {
    const auto found = std::ranges::find(comparison.metrics, key, &ComparedMetric::key);
    return found == comparison.metrics.end() ? comparison.metrics.front() : *found;
}

std::string verdict_on_pm(const Comparison& comparison) {
    std::vector<MetricRho> agreements;
    for (const ComparedMetric& row : comparison.metrics) {
        if (!row.evaluation) return {};
        if (row.metric) agreements.push_back({*row.metric, row.evaluation->rho});
    }
    const std::optional<Metric> best = unbeaten_by_pm(agreements);
    if (!best) return {};
    const std::string by = words_of(mark_of(comparison));
    return std::string("PM does not beat ") + traits(*best).name +
           " on this set, which takes no model of the nerves" +
           (by.empty() ? "." : "; by " + by + " ratings.");
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

NumberMark mark_of(const Comparison& comparison) {
    return comparison.people ? comparison.people->said.mark : NumberMark{};
}

std::string comparison_csv(const Comparison& comparison) {
    std::vector<std::string> cells{"metric", "rho_with_pm", "rho", "rho_low", "rho_high",
                                   "p",      "K",           "K_p", "mark"};
    const std::size_t columns = cells.size();
    std::string csv = csv_row(cells);
    const NumberMark mark = mark_of(comparison) | mark_of(*comparison.request.map->request.set);
    for (const ComparedMetric& row : comparison.metrics) {
        cells = {row.name, shortest_digits(row.rho_with_pm)};
        if (const auto& e = row.evaluation) {
            for (const double value :
                 {e->rho, e->rho_interval.low, e->rho_interval.high, e->rho_p, e->k, e->k_p}) {
                cells.push_back(shortest_digits(value));
            }
        }
        cells.resize(columns - 1);
        cells.push_back(corner_text(mark));
        csv += csv_row(cells);
    }
    return csv;
}

namespace {

// One byte per cell: a few megabytes, and a path fine enough for one line per pixel.
constexpr std::size_t kMostPathSamples = 1500;

std::vector<double> squared_by_step(const PatternCode& a, const PatternCode& b,
                                    const PerReceptor<double>& channel_weight) {
    const std::vector<double> left = predicted_brain_waveform(a.neural, channel_weight);
    const std::vector<double> right = predicted_brain_waveform(b.neural, channel_weight);
    const std::size_t length = std::min(left.size(), right.size());
    std::vector<double> apart((length + kStepSamples - 1) / kStepSamples, 0.0);
    for (std::size_t n = 0; n < length; ++n) {
        const double difference = left[n] - right[n];
        apart[n / kStepSamples] += difference * difference / static_cast<double>(kStepSamples);
    }
    return apart;
}

// With the zeros up to the longest.
std::vector<double> drawn_envelope(const PatternCode& code, std::size_t decimation) {
    std::vector<double> envelope = decimated(code.envelope, decimation, code.samples);
    envelope.resize((code.samples + decimation - 1) / decimation, 0.0);
    return envelope;
}

}  // namespace

std::optional<LiveDifference> compute_live_difference(const DifferenceRequest& request,
                                                      std::stop_token stop,
                                                      std::atomic<float>& progress) {
    const Prediction& prediction = request.map->prediction;
    const PatternCode& a = *prediction.codes[request.a];
    const PatternCode& b = *prediction.codes[request.b];
    const PerReceptor<double>& weight = prediction.params.channel_weight;
    LiveDifference live;
    live.request = request;
    live.shares = nc_shares(spike_form(a.neural, b.neural), weight);
    live.apart = squared_by_step(a, b, weight);
    progress = 0.3F;
    if (stop.stop_requested()) return std::nullopt;
    const std::size_t longest = std::max(a.samples, b.samples);
    live.decimation = std::max<std::size_t>(1, (longest + kMostPathSamples - 1) / kMostPathSamples);
    live.envelope_a = drawn_envelope(a, live.decimation);
    live.envelope_b = drawn_envelope(b, live.decimation);
    live.path = dtw_path(live.envelope_a, live.envelope_b, prediction.params.envelope.waiting_cost);
    progress = 1.0F;
    return live;
}

}  // namespace tact
