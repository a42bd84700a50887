#include "model/ask/gap.h"

#include <algorithm>
#include <cassert>
#include <numeric>

#include "model/subset/subset.h"

namespace tact {

namespace {

constexpr double kPredictionPart = 0.9;  // of the progress

double largest_of(const Dissimilarity& pm) {
    double largest = 0.0;
    for (const double value : pm.condensed) {
        if (value > largest) largest = value;
    }
    return largest;
}

// Pairs of picked ones are as strong as the strongest: they never count as the weakest pair.
Dissimilarity without_picked_pairs(Dissimilarity pm, std::size_t picked) {
    const double largest = largest_of(pm);
    for (std::size_t i = 0; i < picked; ++i) {
        for (std::size_t j = i + 1; j < picked; ++j) {
            pm.condensed[pair_index(pm.size, i, j)] = largest;
        }
    }
    return pm;
}

std::vector<Waveform> felt_waveforms(const GapQuestion& question, const GapOptions& options) {
    std::vector<Waveform> all;
    for (const Vibration& one : question.picked) all.push_back(waveform_of(one));
    for (const Pattern& one : question.candidates) all.push_back(render(one));
    if (!options.felt) return all;
    for (Waveform& one : all) one = options.felt(one);
    return all;
}

}  // namespace

std::optional<GapAnswer> fill_gap(const Dissimilarity& pm, std::size_t picked, std::size_t missing,
                                  const GapOptions& options) {
    assert(picked >= 1 && picked <= pm.size && "there is something to be far from");
    GapAnswer answer{{}, 0.0, largest_of(pm), true};
    const std::size_t wanted = std::min(missing, pm.size - picked);
    if (wanted == 0) return answer;
    SubsetProblem problem{picked + wanted, SubsetObjective::max_min, {}, {}};
    problem.keep.resize(picked);
    std::iota(problem.keep.begin(), problem.keep.end(), std::size_t{0});
    SubsetOptions search;
    search.threads = options.threads;
    search.stop = options.stop;
    search.time_limit_s = options.time_limit_s;
    const auto found = most_distinct_subset(without_picked_pairs(pm, picked), problem, search);
    if (options.stop.stop_requested() || !found) return std::nullopt;
    for (const std::size_t member : found->best.members) {
        if (member >= picked) answer.chosen.push_back(member - picked);
    }
    answer.weakest_pm = found->best.weakest_dissimilarity;
    answer.is_proven = found->proof != SubsetProof::open;
    return answer;
}

std::optional<GapAnswer> fill_gap(const GapQuestion& question, const GapOptions& options) {
    if (question.candidates.empty()) return GapAnswer{};
    PredictOptions how;
    how.threads = options.threads;
    how.stop = options.stop;
    if (question.coarse) how.envelope_decimation = 10;
    if (options.progress) {
        how.progress = [&options](double share) { options.progress(kPredictionPart * share); };
    }
    const auto prediction = predict(felt_waveforms(question, options), question.model, how);
    if (!prediction) return std::nullopt;
    return fill_gap(prediction->pm, question.picked.size(), question.missing, options);
}

}  // namespace tact
