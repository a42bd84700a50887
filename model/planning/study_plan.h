// How sure a rating study of a number of people would be, before it is run: the width of the
// interval of a metric's rho, and how often the metric is told from a rival.
//
// Source    ours, by simulation. Felt is w metric + sqrt(1 - w^2) misfit, both as normal scores:
//           the misfit is that of distances between random points of three dimensions, as what a
//           metric misses belongs to patterns and not to pairs, and w makes Spearman's rho with the
//           metric as it is assumed: w = 2 sin(pi rho / 6) (Pearson 1907). Each person adds noise
//           of their own to every pair. Every simulated study is analysed as a real one is
//           (model/evaluation/uncertainty.h).
// Input     the metric and the rival on the patterns of the study; what is assumed of people
// Output    means and shares over the simulated studies
// Valid     as far as what is assumed: a pilot says it, or a guess, which the answer names
// Left out  the scale's ends, lapses, fatigue; reliability that differs between people.
// Exact     same input, same bits, on any number of threads.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <stop_token>
#include <string>
#include <vector>

#include "model/common/expected.h"
#include "model/common/random.h"
#include "model/dissimilarity/dissimilarity.h"
#include "model/evaluation/uncertainty.h"
#include "model/study/ratings.h"

namespace tact {

struct PlanAssumptions {
    double rho = 0.67;         // of the metric with what people feel on average, without noise
    double reliability = 0.4;  // of one person's ratings: the share that is not their own noise
    std::string source;        // where these are from, a phrase
};

// The mean of PM over Table 2 of Lim & Park 2023, and a reliability that nobody measured here.
PlanAssumptions guessed_assumptions();

// Both as the pilot has them: reliability of one from that of the mean (Spearman-Brown, backwards),
// and rho less what noise took from it. Errors: fewer than two people, nothing in common between
// them, or a metric that does not agree with them.
Expected<PlanAssumptions> assumptions_of(const RatingStudy& pilot, const Dissimilarity& metric);

struct StudyPlan {
    Dissimilarity metric;
    Dissimilarity rival;
    PlanAssumptions assumed;
    std::size_t pairs = 0;  // that each person rates, all as often as each other; 0: every pair
};

struct PlanParams {
    std::size_t studies = 200;  // simulated, of each number of people
    std::size_t draws = 200;    // of patterns and people in the analysis of each
    std::uint64_t seed = 12;
    int threads = 0;  // 0: all cores
    std::stop_token stop{};
    std::function<void(double)> progress{};
};

// Studies with this many people; the arrays are by Resampled. NaN: not known in more than half of
// the studies, as over people if there is one.
struct PlannedStudy {
    std::size_t people = 0;
    double rho = 0.0;          // mean
    double rho_sd = 0.0;       // between studies
    double rho_rival = 0.0;    // mean
    double reliability = 0.0;  // of the mean ratings: Spearman-Brown from that of one
    std::array<double, kResampledCount> half_width{};  // mean, of the 95 % interval of rho
    // The share of the studies that find metric - rival above 0 with p < .05, two-sided.
    std::array<double, kResampledCount> power{};
};

// Pairs that each person rates, dealt like cards from a pack that is shuffled when it is used up:
// `each` different ones a person, and none more often than another by more than one.
std::vector<std::vector<std::size_t>> dealt_pairs(std::size_t pairs, std::size_t people,
                                                  std::size_t each, RandomStream& random);

// None when stopped.
std::optional<std::vector<PlannedStudy>> planned_studies(const StudyPlan& plan,
                                                         std::span<const std::size_t> people,
                                                         const PlanParams& params = {});

// The fewest of these people with a power of `share`; none: not even the most have it.
std::optional<std::size_t> enough_people(std::span<const PlannedStudy> studies, Resampled by,
                                         double share);

}  // namespace tact
