#include "model/ask/gap.h"

#include <algorithm>
#include <cassert>
#include <numeric>

#include "model/ask/vary.h"
#include "model/common/random.h"
#include "model/design_space/candidates.h"
#include "model/pattern/same_vibration.h"
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

namespace {

SeenVibrations seen_of(const PatternSet& set, const std::vector<std::size_t>& picked) {
    SeenVibrations seen;
    for (const std::size_t place : picked) {
        if (const auto* pattern = std::get_if<Pattern>(&set.vibrations[place].source)) {
            seen.add(*pattern);
        }
    }
    return seen;
}

// `wanted` places among `all`: the beginning of a shuffle, in order.
std::vector<std::size_t> some_of(std::size_t all, std::size_t wanted, std::uint64_t seed) {
    std::vector<std::size_t> places(all);
    for (std::size_t k = 0; k < all; ++k) places[k] = k;
    RandomStream random{seed};
    for (std::size_t k = 0; k < wanted; ++k) {
        std::swap(places[k], places[k + next_index(random, all - k)]);
    }
    places.resize(wanted);
    std::ranges::sort(places);
    return places;
}

GapCandidates of_design(const PatternSet& set, const std::vector<std::size_t>& picked,
                        std::uint64_t seed, std::stop_token stop) {
    GapCandidates result;
    const auto made = candidates(*set.generator, set.model.coding.tables, std::move(stop));
    if (!made) return result;
    SeenVibrations seen = seen_of(set, picked);
    const double longest = longest_s(set);
    bool are_all = set.generator->design == Design::factorial;
    std::vector<Pattern> all;
    for (const Candidate& candidate : made->kept) {
        if (candidate.pattern.duration_s > longest) {
            are_all = false;
        } else if (seen.add(candidate.pattern)) {
            all.push_back(candidate.pattern);
        }
    }
    result.of_space = true;
    result.all_there_are = are_all && all.size() <= kMostGapCandidates;
    const std::size_t wanted = std::min(all.size(), kMostGapCandidates);
    for (const std::size_t k : some_of(all.size(), wanted, seed)) result.patterns.push_back(all[k]);
    return result;
}

GapCandidates drawn_around(const PatternSet& set, const std::vector<std::size_t>& picked,
                           const std::vector<PatternParameter>& free, std::uint64_t seed) {
    std::vector<const Pattern*> from;
    for (const std::size_t place : picked) {
        const auto* pattern = std::get_if<Pattern>(&set.vibrations[place].source);
        if (pattern != nullptr && !free_numbers(*pattern, free).empty()) from.push_back(pattern);
    }
    GapCandidates result;
    SeenVibrations seen = seen_of(set, picked);
    RandomStream random{seed};
    for (std::size_t k = 0; k < kDrawnGapCandidates && !from.empty(); ++k) {
        const Pattern& around = *from[k % from.size()];
        const double share = 0.5 + 0.5 * next_even(random);
        const double how_far = 1.0 + share * (kFarthestDrawnSteps - 1.0);
        Pattern one =
            stepped_at_random(around, free_numbers(around, free), set.felt_steps, how_far, random);
        if (seen.add(one)) result.patterns.push_back(std::move(one));
    }
    return result;
}

}  // namespace

GapCandidates gap_candidates(const PatternSet& set, const std::vector<std::size_t>& picked,
                             const std::vector<PatternParameter>& free, std::uint64_t seed,
                             std::stop_token stop) {
    if (set.generator) {
        GapCandidates of_space = of_design(set, picked, seed, std::move(stop));
        if (!of_space.patterns.empty()) return of_space;
    }
    return drawn_around(set, picked, free, seed);
}

}  // namespace tact
