#include "model/perceptual_model/perceptual_model.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <string_view>
#include <unordered_map>
#include <utility>

#include "model/common/parallel.h"
#include "model/dtw/dtw.h"
#include "model/perceptual_model/rhythm_envelope.h"
#include "model/physiology/brain_units.h"
#include "model/physiology/nc_matrix.h"

namespace tact {

namespace {

using Codes = std::span<const std::shared_ptr<const PatternCode>>;

constexpr std::size_t kUnknown = static_cast<std::size_t>(-1);

// Fewer pairs than this are ranked sooner than another thread begins.
constexpr std::size_t kFewPairs = 10'000;

// Without the zeros at its end: whoever gave it may have added them.
std::span<const double> own_samples(const Waveform& waveform) {
    const std::span<const double> all = waveform.samples_g;
    std::size_t count = all.size();
    while (count > 0 && all[count - 1] == 0.0) --count;
    return all.first(count);
}

std::size_t hash_of(const Waveform& waveform) {
    const std::span<const double> own = own_samples(waveform);
    const auto* bytes = reinterpret_cast<const char*>(own.data());
    return std::hash<std::string_view>{}({bytes, own.size_bytes()});
}

Waveform trimmed(const Waveform& waveform) {
    const std::span<const double> own = own_samples(waveform);
    return {waveform.rate_hz, {own.begin(), own.end()}};
}

bool is_code_of(const PatternCode& code, const Waveform& waveform, std::size_t samples) {
    return code.samples == samples && !code.is_quick && code.waveform.rate_hz == waveform.rate_hz &&
           std::ranges::equal(code.waveform.samples_g, own_samples(waveform));
}

// Where each code stood in the earlier prediction; a code is shared exactly when it was reused.
std::vector<std::size_t> earlier_places(Codes codes, const Prediction* previous) {
    std::vector<std::size_t> places(codes.size(), kUnknown);
    if (previous == nullptr) return places;
    std::unordered_map<const PatternCode*, std::size_t> earlier;
    for (std::size_t k = 0; k < previous->codes.size(); ++k) {
        earlier.emplace(previous->codes[k].get(), k);
    }
    for (std::size_t k = 0; k < codes.size(); ++k) {
        if (const auto found = earlier.find(codes[k].get()); found != earlier.end()) {
            places[k] = found->second;
        }
    }
    return places;
}

// What `known` has of pairs whose patterns were both in it.
KnownPairs known_pairs(Codes codes, const Prediction* previous, const Dissimilarity* known) {
    KnownPairs result{{codes.size(), std::vector<double>(pair_count(codes.size()))}, {}};
    const auto places = earlier_places(codes, known == nullptr ? nullptr : previous);
    std::size_t index = 0;
    for (std::size_t i = 0; i < codes.size(); ++i) {
        for (std::size_t j = i + 1; j < codes.size(); ++j, ++index) {
            if (places[i] != kUnknown && places[j] != kUnknown) {
                result.matrix.condensed[index] = (*known)(places[i], places[j]);
            } else {
                result.open.push_back(index);
            }
        }
    }
    return result;
}

// Pairs by blocks of patterns that fit into a cache together: row by row each pair would fetch its
// second pattern from far away.
struct BlockedPairs {
    std::vector<std::size_t> pairs;  // condensed
    std::vector<std::size_t> begin;  // of each block, and the end
};

BlockedPairs by_block(std::size_t patterns, std::span<const std::size_t> pairs) {
    constexpr std::size_t kSide = 8;
    const std::size_t across = (patterns + kSide - 1) / kSide;
    const auto block_of = [&](std::size_t index) {
        const auto [i, j] = pair_at(patterns, index);
        return i / kSide * across + j / kSide;
    };
    BlockedPairs blocked{std::vector<std::size_t>(pairs.size()),
                         std::vector<std::size_t>(across * across + 1)};
    for (const std::size_t index : pairs) ++blocked.begin[block_of(index) + 1];
    std::partial_sum(blocked.begin.begin(), blocked.begin.end(), blocked.begin.begin());
    std::vector<std::size_t> next = blocked.begin;
    for (const std::size_t index : pairs) blocked.pairs[next[block_of(index)]++] = index;
    return blocked;
}

bool same_codes(const PerceptualModelParams& a, const PerceptualModelParams& b) {
    return a.coding == b.coding && a.envelope == b.envelope;
}

// The earlier prediction, if its parts answer the same question.
const Prediction* usable(const PredictOptions& options, const PerceptualModelParams& params) {
    const Prediction* previous = options.previous;
    return previous != nullptr && same_codes(previous->params, params) ? previous : nullptr;
}

}  // namespace

std::vector<std::shared_ptr<const PatternCode>> pattern_codes(std::span<const Waveform> waveforms,
                                                              const PerceptualModelParams& params,
                                                              const PredictOptions& options) {
    std::unordered_multimap<std::size_t, std::shared_ptr<const PatternCode>> earlier;
    if (const Prediction* previous = usable(options, params)) {
        for (const auto& code : previous->codes) earlier.emplace(hash_of(code->waveform), code);
    }
    std::size_t samples = options.samples;
    for (const Waveform& one : waveforms) samples = std::max(samples, one.samples_g.size());
    std::vector<std::shared_ptr<const PatternCode>> codes(waveforms.size());
    const bool finished =
        parallel_for(waveforms.size(), options.threads, options.stop, [&](std::size_t k) {
            if (!earlier.empty()) {
                const auto [first, last] = earlier.equal_range(hash_of(waveforms[k]));
                for (auto candidate = first; candidate != last; ++candidate) {
                    if (is_code_of(*candidate->second, waveforms[k], samples)) {
                        codes[k] = candidate->second;
                    }
                }
            }
            if (codes[k]) return;
            PatternCode code;
            code.waveform = trimmed(waveforms[k]);
            code.samples = samples;
            code.is_quick = options.quick_codes && can_be_quick(code.waveform, samples);
            code.neural = code.is_quick
                              ? quick_neural_code(code.waveform, samples, params.coding)
                              : neural_code(coded_waveform(code), params.coding, {options.stop});
            if (options.stop.stop_requested()) return;
            drop_silent_end(code.neural);
            code.envelope = own_rhythm_envelope(code.waveform.samples_g, samples, params.envelope);
            codes[k] = std::make_shared<const PatternCode>(std::move(code));
        });
    if (!finished || options.stop.stop_requested()) codes.clear();
    return codes;
}

PartShares part_shares(const Prediction& prediction, std::size_t pair) {
    const PerceptualModelParams& params = prediction.params;
    const double of_nc = is_zero_among(prediction.nc.condensed, pair)
                             ? 0.0
                             : params.nc_weight * prediction.nc_rank[pair];
    const double of_oc = is_zero_among(prediction.oc.condensed, pair)
                             ? 0.0
                             : params.oc_weight * prediction.oc_rank[pair];
    const double all = of_nc + of_oc;
    return all > 0.0 ? PartShares{of_nc / all, of_oc / all} : PartShares{};
}

Waveform coded_waveform(const PatternCode& code) { return padded(code.waveform, code.samples); }

SignalPair envelopes_of(const PatternCode& a, const PatternCode& b) {
    return {a.envelope, b.envelope, a.samples, b.samples};
}

bool is_felt(const PatternCode& code) {
    return std::ranges::any_of(code.neural.activation,
                               [](const Activation& channel) { return channel.rate_hz > 0.0; });
}

std::vector<std::size_t> unfelt(std::span<const std::shared_ptr<const PatternCode>> codes) {
    std::vector<std::size_t> places;
    for (std::size_t k = 0; k < codes.size(); ++k) {
        if (!is_felt(*codes[k])) places.push_back(k);
    }
    return places;
}

Dissimilarity nc_matrix(Codes codes, const PerceptualModelParams& params,
                        const PredictOptions& options) {
    const Prediction* previous = usable(options, params);
    const bool same_weights =
        previous != nullptr && previous->params.channel_weight == params.channel_weight;
    auto pairs = known_pairs(codes, previous, same_weights ? &previous->nc : nullptr);
    // No progress: a thousandth of the work of OC.
    const std::optional<WeightUnits> units = weight_units(params.channel_weight);
    std::vector<BrainUnits> brains(units ? codes.size() : 0);
    std::vector<PackedSpikes> spikes(units ? 0 : codes.size());
    parallel_for(codes.size(), options.threads, options.stop, [&](std::size_t k) {
        if (units) {
            brains[k] = brain_units(codes[k]->neural, *units);
        } else {
            spikes[k] = packed_spikes(codes[k]->neural);
        }
    });
    const BlockedPairs blocked = by_block(codes.size(), pairs.open);
    parallel_for(blocked.begin.size() - 1, options.threads, options.stop, [&](std::size_t block) {
        for (std::size_t k = blocked.begin[block]; k < blocked.begin[block + 1]; ++k) {
            const auto [i, j] = pair_at(codes.size(), blocked.pairs[k]);
            pairs.matrix.condensed[blocked.pairs[k]] =
                units ? nc_dissimilarity(brains[i], brains[j], *units)
                      : nc_dissimilarity(spikes[i], spikes[j], params.channel_weight);
        }
    });
    return std::move(pairs.matrix);
}

KnownPairs known_oc(Codes codes, const PerceptualModelParams& params,
                    const PredictOptions& options) {
    const Prediction* previous = options.previous;
    const bool same_warp = previous != nullptr &&
                           previous->envelope_decimation == options.envelope_decimation &&
                           previous->params.envelope.waiting_cost == params.envelope.waiting_cost;
    return known_pairs(codes, previous, same_warp ? &previous->oc : nullptr);
}

Dissimilarity oc_matrix(Codes codes, const PerceptualModelParams& params,
                        const PredictOptions& options) {
    const std::size_t factor = options.envelope_decimation;
    const double waiting_cost = params.envelope.waiting_cost;
    auto [matrix, open] = known_oc(codes, params, options);
    std::vector<std::vector<double>> coarse(factor == 1 ? 0 : codes.size());
    for (std::size_t k = 0; k < coarse.size(); ++k) {
        coarse[k] = decimated(codes[k]->envelope, factor, codes[k]->samples);
    }
    std::vector<SignalPair> pairs;
    pairs.reserve(open.size());
    for (const std::size_t index : open) {
        const auto [i, j] = pair_at(codes.size(), index);
        if (factor == 1) {
            pairs.push_back(envelopes_of(*codes[i], *codes[j]));
        } else {
            const std::size_t blocks = (codes[i]->samples + factor - 1) / factor;
            pairs.push_back({coarse[i], coarse[j], blocks, blocks});
        }
    }
    const auto distances =
        dtw(pairs, {options.threads, waiting_cost, options.stop, options.progress});
    // A path through coarse envelopes has a factor-th of the steps.
    const auto scale = static_cast<double>(factor);
    for (std::size_t k = 0; k < open.size(); ++k) matrix.condensed[open[k]] = scale * distances[k];
    return matrix;
}

namespace {

Prediction ranked(std::vector<std::shared_ptr<const PatternCode>> codes,
                  const PerceptualModelParams& params, Dissimilarity nc, Dissimilarity oc,
                  int threads) {
    Prediction result;
    result.params = params;
    result.codes = std::move(codes);
    result.nc = std::move(nc);
    result.oc = std::move(oc);
    if (result.nc.condensed.size() < kFewPairs) threads = 1;
    parallel_for(2, threads, {}, [&result](std::size_t part) {
        if (part == 0) result.nc_rank = average_ranks(result.nc.condensed);
        if (part == 1) result.oc_rank = average_ranks(result.oc.condensed);
    });
    result.pm = {result.nc.size, std::vector<double>(result.nc_rank.size())};
    for (std::size_t k = 0; k < result.pm.condensed.size(); ++k) {
        result.pm.condensed[k] =
            pm_of(result.nc_rank[k], result.oc_rank[k], params.nc_weight, params.oc_weight);
    }
    return result;
}

}  // namespace

Prediction prediction_of(std::vector<std::shared_ptr<const PatternCode>> codes,
                         const PerceptualModelParams& params, Dissimilarity nc, Dissimilarity oc) {
    return ranked(std::move(codes), params, std::move(nc), std::move(oc), 1);
}

std::optional<Prediction> predict(std::vector<std::shared_ptr<const PatternCode>> codes,
                                  const PerceptualModelParams& params,
                                  const PredictOptions& options) {
    Dissimilarity nc = nc_matrix(codes, params, options);
    Dissimilarity oc = oc_matrix(codes, params, options);
    if (options.stop.stop_requested()) return std::nullopt;
    Prediction result =
        ranked(std::move(codes), params, std::move(nc), std::move(oc), options.threads);
    result.envelope_decimation = options.envelope_decimation;
    return result;
}

std::optional<Prediction> predict(std::span<const Waveform> waveforms,
                                  const PerceptualModelParams& params,
                                  const PredictOptions& options) {
    auto codes = pattern_codes(waveforms, params, options);
    if (codes.size() != waveforms.size()) return std::nullopt;
    return predict(std::move(codes), params, options);
}

namespace {

// Beyond 64 bits: weights of up to 1000 in units of 1e-12, ranks of up to 5e7 pairs.
__extension__ using Wide = __int128;

Wide part(double rank, double weight) {
    return static_cast<Wide>(std::llround(2.0 * rank)) * weight_units(weight);
}

}  // namespace

double pm_of(double nc_rank, double oc_rank, double nc_weight, double oc_weight) {
    const Wide sum = part(nc_rank, nc_weight) + part(oc_rank, oc_weight);
    return static_cast<double>(sum) / (2.0 * kWeightUnits);
}

}  // namespace tact
