#include "model/ask/gap_candidates.h"

#include <algorithm>

#include "model/ask/vary.h"
#include "model/common/random.h"
#include "model/design_space/candidates.h"
#include "model/pattern/same_vibration.h"

namespace tact {

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
