#include "model/ask/path_distances.h"

#include <algorithm>

#include "model/common/parallel.h"
#include "model/dtw/dtw.h"
#include "model/perceptual_model/rhythm_envelope.h"

namespace tact {

namespace {

constexpr std::size_t kCoarse = 10;
// Envelopes that differ by less than this, a sample on average, differ by rounding.
constexpr double kNothing = 1e-6;

}  // namespace

PathDistances::PathDistances(const StepsQuestion& question, const StepsOptions& options)
    : question_(question),
      options_(options),
      samples_(std::max(sample_count(question.from.duration_s, kModelRateHz),
                        sample_count(question.to.duration_s, kModelRateHz))),
      morph_(question.from, question.to) {}

Pattern PathDistances::at(double share) const { return morph_.at(share); }

bool PathDistances::prepare(const std::vector<double>& shares) {
    std::vector<double> missing;
    for (const double share : shares) {
        if (!places_.contains(share)) missing.push_back(share);
    }
    std::ranges::sort(missing);
    missing.erase(std::unique(missing.begin(), missing.end()), missing.end());
    std::vector<Waveform> waveforms(missing.size());
    parallel_for(missing.size(), options_.threads, options_.stop,
                 [&](std::size_t k) { waveforms[k] = padded(render(at(missing[k])), samples_); });
    if (options_.stop.stop_requested()) return false;
    PredictOptions predicting;
    predicting.threads = options_.threads;
    predicting.stop = options_.stop;
    const auto codes = pattern_codes(waveforms, question_.model, predicting);
    if (codes.size() != missing.size()) return false;
    for (std::size_t k = 0; k < missing.size(); ++k) {
        places_[missing[k]] = {codes[k], decimated(codes[k]->envelope, kCoarse, samples_)};
    }
    return true;
}

std::vector<double> PathDistances::nc_of(const Pairs& pairs) const {
    std::vector<double> distances(pairs.size());
    parallel_for(pairs.size(), options_.threads, options_.stop, [&](std::size_t k) {
        distances[k] = nc_dissimilarity(places_.at(pairs[k].first).code->neural,
                                        places_.at(pairs[k].second).code->neural,
                                        question_.model.channel_weight);
    });
    return distances;
}

std::vector<double> PathDistances::oc_of(const Pairs& pairs, bool exact) const {
    std::vector<SignalPair> signals;
    for (const auto& [a, b] : pairs) {
        const Place& first = places_.at(a);
        const Place& second = places_.at(b);
        if (exact) {
            signals.push_back(envelopes_of(*first.code, *second.code));
        } else {
            const std::size_t blocks = (samples_ + kCoarse - 1) / kCoarse;
            signals.push_back({first.coarse, second.coarse, blocks, blocks});
        }
    }
    auto distances =
        dtw(signals, {options_.threads, question_.model.envelope.waiting_cost, options_.stop, {}});
    if (!exact) {
        for (double& distance : distances) distance *= static_cast<double>(kCoarse);
    }
    return distances;
}

std::vector<double> PathDistances::of(const Pairs& pairs, bool exact) const {
    std::vector<double> sum(pairs.size(), 0.0);
    if (nc_scale_ > 0.0) {
        const std::vector<double> nc = nc_of(pairs);
        for (std::size_t k = 0; k < sum.size(); ++k) sum[k] += nc_scale_ * nc[k];
    }
    if (oc_scale_ > 0.0) {
        const std::vector<double> oc = oc_of(pairs, exact);
        for (std::size_t k = 0; k < sum.size(); ++k) sum[k] += oc_scale_ * oc[k];
    }
    return sum;
}

void PathDistances::scale_by(const Pairs& pairs) {
    if (pairs.empty() || question_.measure != StepMeasure::pm) return scale_to(1.0, 1.0);
    const std::vector<double> nc = nc_of(pairs);
    const std::vector<double> oc = oc_of(pairs, false);
    const auto widest = std::ranges::max_element(oc) - oc.begin();
    const Pairs one{pairs[static_cast<std::size_t>(widest)]};
    scale_to(*std::ranges::max_element(nc), oc_of(one, true).front());
}

void PathDistances::scale_to(double largest_nc, double largest_oc) {
    if (question_.measure != StepMeasure::pm) {
        nc_scale_ = question_.measure == StepMeasure::nc ? 1.0 : 0.0;
        oc_scale_ = question_.measure == StepMeasure::oc ? 1.0 : 0.0;
        return;
    }
    const double nothing = kNothing * static_cast<double>(samples_);
    nc_scale_ = largest_nc > 0.0 ? question_.model.nc_weight / largest_nc : 0.0;
    oc_scale_ = largest_oc > nothing ? question_.model.oc_weight / largest_oc : 0.0;
}

}  // namespace tact
