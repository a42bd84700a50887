#include "model/library/likeness.h"

#include <algorithm>
#include <memory>
#include <utility>

#include "model/common/parallel.h"
#include "model/dissimilarity/dissimilarity.h"
#include "model/dtw/dtw.h"
#include "model/perceptual_model/perceptual_model.h"
#include "model/perceptual_model/rank_sum.h"

namespace tact {

namespace {

// Number of codes in memory at once.
constexpr std::size_t kAtOnce = 64;

// Coding is about this share of the work.
constexpr double kCodingShare = 0.4;

using Code = std::shared_ptr<const PatternCode>;

struct Row {
    const Waveform& wanted;
    Code own;  // of the wanted one at its own length
    const PerceptualModelParams& params;
    const LikenessOptions& options;
    LikenessRow result{};
};

// Null when stopped.
Code code_of(Waveform waveform, const Row& row) {
    const std::vector<Waveform> one{std::move(waveform)};
    const auto codes =
        pattern_codes(one, row.params, {.threads = 1, .stop = row.options.stop, .progress = {}});
    return codes.empty() ? nullptr : codes.front();
}

struct Pair {
    Code wanted;
    Code other;
};

Pair pair_of(const Row& row, const Waveform& other) {
    const std::size_t own = row.wanted.samples_g.size();
    const std::size_t samples = std::max(own, other.samples_g.size());
    return {samples == own ? row.own : code_of(padded(row.wanted, samples), row),
            code_of(padded(other, samples), row)};
}

// False when stopped.
bool add_to(Row& row, std::span<const Waveform> others,
            const std::function<void(double)>& progress) {
    const LikenessOptions& options = row.options;
    std::vector<Pair> pairs(others.size());
    parallel_for(others.size(), options.threads, options.stop,
                 [&](std::size_t k) { pairs[k] = pair_of(row, others[k]); });
    if (options.stop.stop_requested()) return false;
    if (progress) progress(kCodingShare);
    std::vector<SignalPair> envelopes;
    for (const Pair& pair : pairs) {
        row.result.nc.push_back(
            nc_dissimilarity(pair.wanted->neural, pair.other->neural, row.params.channel_weight));
        row.result.felt.push_back(is_felt(*pair.other));
        envelopes.push_back(envelopes_of(*pair.wanted, *pair.other));
    }
    DtwOptions warping{.threads = options.threads,
                       .waiting_cost = row.params.envelope.waiting_cost,
                       .stop = options.stop};
    if (progress) {
        warping.progress = [&progress](double share) {
            progress(kCodingShare + (1.0 - kCodingShare) * share);
        };
    }
    const std::vector<double> oc = dtw(envelopes, warping);
    row.result.oc.insert(row.result.oc.end(), oc.begin(), oc.end());
    return !options.stop.stop_requested();
}

}  // namespace

bool is_comparable(double duration_s, double with_duration_s) {
    return duration_s <= std::max(kLongestAlwaysS, kLongestTimes * with_duration_s);
}

std::optional<LikenessRow> likeness_row(const Waveform& wanted, std::span<const Waveform> others,
                                        const PerceptualModelParams& params,
                                        const LikenessOptions& options) {
    Row row{wanted, nullptr, params, options};
    row.own = code_of(wanted, row);
    if (!row.own) return std::nullopt;
    row.result.is_wanted_felt = is_felt(*row.own);
    for (std::size_t first = 0; first < others.size(); first += kAtOnce) {
        const auto some = others.subspan(first, std::min(kAtOnce, others.size() - first));
        std::function<void(double)> progress;
        if (options.progress) {
            progress = [&, here = some.size()](double share) {
                options.progress((static_cast<double>(first) + share * static_cast<double>(here)) /
                                 static_cast<double>(others.size()));
            };
        }
        if (!add_to(row, some, progress)) return std::nullopt;
    }
    LikenessRow& result = row.result;
    const std::vector<double> nc_rank = average_ranks(result.nc);
    const std::vector<double> oc_rank = average_ranks(result.oc);
    for (std::size_t k = 0; k < others.size(); ++k) {
        result.pm.push_back(pm_of(nc_rank[k], oc_rank[k], params.nc_weight, params.oc_weight));
    }
    return std::move(result);
}

}  // namespace tact
