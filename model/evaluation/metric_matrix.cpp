#include "model/evaluation/metric_matrix.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cassert>
#include <cmath>
#include <utility>

#include "model/common/parallel.h"
#include "model/dtw/dtw.h"
#include "model/metrics/band_levels.h"
#include "model/metrics/frequency_balance.h"
#include "model/metrics/level_difference.h"
#include "model/metrics/rank_average.h"
#include "model/perceptual_model/perceptual_model.h"
#include "model/perceptual_model/rhythm_envelope.h"

namespace tact {

namespace {

using Waveforms = std::span<const Waveform>;

std::size_t longest_of(Waveforms waveforms) {
    std::size_t longest = 0;
    for (const Waveform& waveform : waveforms) {
        longest = std::max(longest, waveform.samples_g.size());
    }
    return longest;
}

// What `prepare` makes of each waveform, compared pair by pair.
template <class Prepare, class Compare>
std::optional<Dissimilarity> compared_as_they_are(Waveforms waveforms, const MetricOptions& options,
                                                  const Prepare& prepare, const Compare& compare) {
    const std::size_t n = waveforms.size();
    std::vector<decltype(prepare(waveforms[0]))> prepared(n);
    parallel_for(n, options.threads, options.stop,
                 [&](std::size_t k) { prepared[k] = prepare(waveforms[k]); });
    Dissimilarity matrix{n, std::vector<double>(pair_count(n))};
    // Few enough for a stop, enough that threads do not wait for each other.
    constexpr std::size_t kAtOnce = 16;
    const std::size_t portions = (matrix.condensed.size() + kAtOnce - 1) / kAtOnce;
    std::atomic<std::size_t> done{0};
    parallel_for(portions, options.threads, options.stop, [&](std::size_t portion) {
        const std::size_t begin = portion * kAtOnce;
        const std::size_t end = std::min(begin + kAtOnce, matrix.condensed.size());
        for (std::size_t k = begin; k < end; ++k) {
            const auto [i, j] = pair_at(n, k);
            matrix.condensed[k] = compare(prepared[i], prepared[j]);
        }
        const std::size_t so_far = done += end - begin;
        if (!options.progress) return;
        options.progress(static_cast<double>(so_far) /
                         static_cast<double>(matrix.condensed.size()));
    });
    if (options.stop.stop_requested()) return std::nullopt;
    return matrix;
}

// The same of waveforms with zeros up to the longest, which are there one at a time.
template <class Prepare, class Compare>
std::optional<Dissimilarity> compared(Waveforms waveforms, const MetricOptions& options,
                                      const Prepare& prepare, const Compare& compare) {
    const std::size_t longest = longest_of(waveforms);
    return compared_as_they_are(
        waveforms, options, [&](const Waveform& own) { return prepare(padded(own, longest)); },
        compare);
}

// One of a pair is the reference: as asked for, or both ways.
template <class OneWay>
auto directed(const MetricOptions& options, const OneWay& one_way) {
    return [direction = options.direction, one_way](const auto& x, const auto& y) {
        if (direction == Direction::first_is_reference) return one_way(x, y);
        return (one_way(x, y) + one_way(y, x)) / 2.0;
    };
}

// Every pair of signals, warped. Zeros follow each, up to `samples`.
std::optional<Dissimilarity> warped(const std::vector<std::span<const double>>& signals,
                                    std::size_t samples, double waiting_cost,
                                    const MetricOptions& options) {
    std::vector<SignalPair> pairs;
    for (std::size_t i = 0; i < signals.size(); ++i) {
        for (std::size_t j = i + 1; j < signals.size(); ++j) {
            pairs.push_back({signals[i], signals[j], samples, samples});
        }
    }
    Dissimilarity matrix{signals.size(), dtw(pairs, {options.threads, waiting_cost, options.stop,
                                                     options.progress})};
    if (options.stop.stop_requested()) return std::nullopt;
    return matrix;
}

std::optional<Dissimilarity> dtw_matrix(Waveforms waveforms, const MetricOptions& options) {
    const RawDtwParams& params = options.baseline.dtw;
    if (!is_plain(params)) {
        return compared_as_they_are(
            waveforms, options, [](const Waveform& x) { return x.samples_g; },
            [&](const auto& x, const auto& y) { return raw_dtw(x, y, params); });
    }
    std::vector<std::span<const double>> signals;
    for (const Waveform& waveform : waveforms) signals.emplace_back(waveform.samples_g);
    auto matrix = warped(signals, 0, 0.0, options);
    if (!matrix) return matrix;
    for (std::size_t k = 0; k < matrix->condensed.size(); ++k) {
        const auto [i, j] = pair_at(signals.size(), k);
        matrix->condensed[k] =
            normalised_dtw(matrix->condensed[k], signals[i].size(), signals[j].size(), params);
    }
    return matrix;
}

// OC by itself is the part that PM has of it: the same envelopes, at the same cost of waiting.
std::optional<Dissimilarity> envelope_matrix(Waveforms waveforms, const EnvelopeParams& params,
                                             const MetricOptions& options) {
    const std::size_t samples = longest_of(waveforms);
    std::vector<std::vector<double>> envelopes(waveforms.size());
    parallel_for(waveforms.size(), options.threads, options.stop, [&](std::size_t k) {
        envelopes[k] = own_rhythm_envelope(waveforms[k].samples_g, samples, params);
    });
    return warped({envelopes.begin(), envelopes.end()}, samples, params.waiting_cost, options);
}

Spectrum spectrum_of(const Waveform& waveform) {
    return amplitude_spectrum(waveform.samples_g, waveform.rate_hz);
}

std::optional<Dissimilarity> rmse_matrix(Waveforms waveforms, const MetricOptions& options) {
    const SpectralRmseParams& params = options.baseline.rmse;
    const auto lines_of = [&](const Waveform& x) { return compared_lines(spectrum_of(x), params); };
    const auto one_way = [&params](const auto& x, const auto& y) {
        return spectral_rmse(x, y, params);
    };
    // The other errors are the same both ways.
    if (params.error != SpectralError::normalised) {
        return compared(waveforms, options, lines_of, one_way);
    }
    return compared(waveforms, options, lines_of, directed(options, one_way));
}

std::optional<Dissimilarity> msm_matrix(Waveforms waveforms, const MetricOptions& options) {
    const SpectralMatchingParams& params = options.baseline.msm;
    return compared(
        waveforms, options,
        [&](const Waveform& x) { return sub_band_spectrum(spectrum_of(x), params); },
        [&](const auto& x, const auto& y) { return spectral_matching(x, y, params); });
}

std::optional<Dissimilarity> mtm_matrix(Waveforms waveforms, const MetricOptions& options) {
    const TemporalMatchingParams& params = options.baseline.mtm;
    return compared(
        waveforms, options, [&](const Waveform& x) { return centred_samples(x.samples_g, params); },
        [&](const auto& x, const auto& y) { return temporal_matching(x, y, params); });
}

std::optional<Dissimilarity> st_sim_matrix(Waveforms waveforms, const MetricOptions& options) {
    const StSimParams& params = options.baseline.st_sim;
    return compared(
        waveforms, options, [&](const Waveform& x) { return st_sim_blocks(x, params); },
        directed(options, [&params](const StSimBlocks& x, const StSimBlocks& y) {
            return 1.0 - st_sim(x, y, params).similarity;
        }));
}

std::optional<Dissimilarity> spqi_matrix(Waveforms waveforms, const MetricOptions& options) {
    const SpqiParams& params = options.baseline.spqi;
    return compared(
        waveforms, options, [&](const Waveform& x) { return spqi_blocks(x, params); },
        directed(options, [&params](const SpqiBlocks& x, const SpqiBlocks& y) {
            return spqi_distance(x, y, params);
        }));
}

std::optional<Dissimilarity> level_matrix(Waveforms waveforms, const MetricOptions& options) {
    return compared(
        waveforms, options, [](const Waveform& x) { return level_db(x.samples_g); },
        [](double x_db, double y_db) { return std::abs(x_db - y_db); });
}

std::optional<Dissimilarity> bands_matrix(Waveforms waveforms, const PhysiologyTables& tables,
                                          const MetricOptions& options) {
    return compared(
        waveforms, options,
        [&](const Waveform& x) {
            return band_levels_db(amplitude_spectrum(without_mean(x.samples_g), x.rate_hz), tables);
        },
        band_distance);
}

std::optional<Dissimilarity> balance_matrix(Waveforms waveforms, const MetricOptions& options) {
    return compared(
        waveforms, options,
        [](const Waveform& x) {
            return frequency_balance_db(amplitude_spectrum(without_mean(x.samples_g), x.rate_hz));
        },
        [](double x_db, double y_db) { return std::abs(x_db - y_db); });
}

std::optional<Dissimilarity> van_rossum_matrix(Waveforms waveforms,
                                               const PerceptualModelParams& params,
                                               const MetricOptions& options) {
    const VanRossumParams& distance = options.baseline.van_rossum;
    return compared(
        waveforms, options,
        [&](const Waveform& x) {
            return spike_tails(neural_code(x, params.coding, {options.stop}), params.channel_weight,
                               distance);
        },
        [&](const auto& x, const auto& y) { return van_rossum(x, y, distance); });
}

std::optional<Dissimilarity> no_physiology_matrix(Waveforms waveforms,
                                                  const PerceptualModelParams& params,
                                                  MetricOptions options) {
    const auto oc = envelope_matrix(waveforms, params.envelope, options);
    options.progress = {};  // the rest is a hundredth of the work
    const auto msm = msm_matrix(waveforms, options);
    const auto mtm = mtm_matrix(waveforms, options);
    if (!oc || !msm || !mtm) return std::nullopt;
    return rank_average(std::array{*msm, *mtm, *oc});
}

std::optional<Dissimilarity> model_matrix(Metric metric, Waveforms waveforms,
                                          const PerceptualModelParams& params,
                                          const MetricOptions& options) {
    PredictOptions model;
    model.threads = options.threads;
    model.stop = options.stop;
    model.progress = options.progress;
    if (metric == Metric::pm) {
        auto prediction = predict(waveforms, params, model);
        return prediction ? std::optional(std::move(prediction->pm)) : std::nullopt;
    }
    const auto codes = pattern_codes(waveforms, params, model);
    if (codes.size() != waveforms.size()) return std::nullopt;
    auto matrix = nc_matrix(codes, params, model);
    if (options.stop.stop_requested()) return std::nullopt;
    return matrix;
}

}  // namespace

std::optional<Dissimilarity> metric_matrix(Metric metric, std::span<const Waveform> waveforms,
                                           const PerceptualModelParams& params,
                                           const MetricOptions& options) {
    assert(std::ranges::all_of(
               waveforms, [&](const Waveform& x) { return x.rate_hz == waveforms[0].rate_hz; }) &&
           "waveforms of different rates");
    switch (metric) {
        case Metric::pm:
        case Metric::nc:
            return model_matrix(metric, waveforms, params, options);
        case Metric::oc:
            return envelope_matrix(waveforms, params.envelope, options);
        case Metric::rmse:
            return rmse_matrix(waveforms, options);
        case Metric::msm:
            return msm_matrix(waveforms, options);
        case Metric::mtm:
            return mtm_matrix(waveforms, options);
        case Metric::st_sim:
            return st_sim_matrix(waveforms, options);
        case Metric::spqi:
            return spqi_matrix(waveforms, options);
        case Metric::level:
            return level_matrix(waveforms, options);
        case Metric::bands:
            return bands_matrix(waveforms, params.coding.tables, options);
        case Metric::balance:
            return balance_matrix(waveforms, options);
        case Metric::van_rossum:
            return van_rossum_matrix(waveforms, params, options);
        case Metric::no_physiology:
            return no_physiology_matrix(waveforms, params, options);
        case Metric::dtw:
            return dtw_matrix(waveforms, options);
    }
    assert(false && "no such metric");
    return std::nullopt;
}

namespace {

// What its values are counted from where they are ranked.
double origin_of(Metric metric, const BaselineParams& params) {
    const bool is_score = metric == Metric::spqi && params.spqi.distance == SpqiDistance::score;
    return is_score ? 1.0 : 0.0;
}

}  // namespace

std::vector<double> values_to_rank(Metric metric, const Dissimilarity& matrix,
                                   const BaselineParams& params) {
    std::vector<double> values = matrix.condensed;
    const double origin = origin_of(metric, params);
    for (double& value : values) value -= origin;
    return values;
}

Dissimilarity as_ranked(Metric metric, Dissimilarity matrix, const BaselineParams& params) {
    tie_rounding_noise(matrix.condensed, origin_of(metric, params));
    return matrix;
}

}  // namespace tact
