#include "model/study/adaptive_order.h"

#include <doctest/doctest.h>

#include <cmath>
#include <map>
#include <set>

#include "model/common/random.h"
#include "model/map/alienation.h"
#include "model/map/mds.h"
#include "model/map/smacof.h"
#include "model/study/synthetic_study.h"

namespace adaptive_order_test {

using namespace tact;

namespace {

constexpr std::size_t kPatterns = 9;

struct Flat {
    Eigen::MatrixXd points;
    Dissimilarity distance;
};

Flat flat_map(std::uint64_t seed) {
    Flat map{random_start(kPatterns, 2, seed, 1), {}};
    map.distance = {kPatterns, distances(map.points)};
    return map;
}

std::vector<RatedTrial> answered(const TrialPlan& plan, const SyntheticRater& rater,
                                 std::size_t most) {
    std::vector<RatedTrial> answers;
    while (answers.size() < most) {
        const auto trial = next_adaptive_trial(plan, answers);
        if (!trial) break;
        answers.push_back({*trial, rating_of(rater, *trial, answers.size())});
    }
    return answers;
}

std::vector<RatedTrial> in_random_order(const TrialPlan& plan, const SyntheticRater& rater,
                                        std::size_t most) {
    std::vector<RatedTrial> answers;
    for (const Trial& trial : trial_list(plan)) {
        if (answers.size() < most) {
            answers.push_back({trial, rating_of(rater, trial, answers.size())});
        }
    }
    return answers;
}

// K between the true map and that of the answers.
double alienation_of(const Flat& truth, const std::vector<RatedTrial>& answers) {
    Dissimilarity known{kPatterns, std::vector<double>(pair_count(kPatterns), std::nan(""))};
    for (const RatedTrial& answer : answers) {
        if (answer.trial.is_attention()) continue;
        const auto [low, high] = std::minmax(answer.trial.left, answer.trial.right);
        known.condensed[pair_index(kPatterns, low, high)] = 100.0 - answer.similarity;
    }
    MdsParams params;
    params.dimensions = 2;
    params.threads = 1;
    params.random_starts = 20;
    return *alienation(nonmetric_mds(known, params).points, truth.points);
}

}  // namespace

TEST_CASE("adaptive order: to the end it is the full design's trials in another order") {
    const TrialPlan plan{5, 2, 2, 4};
    const SyntheticRater rater{{}, {5, {1, 2, 3, 4, 5, 6, 7, 8, 9, 10}}, 1};
    const auto answers = answered(plan, rater, 1000);
    CHECK(answers.size() == trial_list(plan).size());
    std::multiset<std::pair<std::size_t, std::size_t>> asked;
    std::multiset<std::pair<std::size_t, std::size_t>> full;
    for (const RatedTrial& answer : answers) {
        asked.insert({answer.trial.left, answer.trial.right});
    }
    for (const Trial& trial : trial_list(plan)) full.insert({trial.left, trial.right});
    CHECK(asked == full);
    for (std::size_t k = 1; k < answers.size(); ++k) {
        CHECK(std::minmax(answers[k].trial.left, answers[k].trial.right) !=
              std::minmax(answers[k - 1].trial.left, answers[k - 1].trial.right));
    }
}

TEST_CASE("adaptive order: after two rounds the map is nearer to the truth than by random order") {
    double adaptive = 0.0;
    double random = 0.0;
    constexpr int kStudies = 12;
    for (std::uint64_t seed = 1; seed <= kStudies; ++seed) {
        const Flat truth = flat_map(seed);
        const SyntheticRater rater{{4.0, 0.0, 0.0, 0.0, seed}, truth.distance, 1};
        const TrialPlan plan{kPatterns, 1, 0, seed};
        adaptive += alienation_of(truth, answered(plan, rater, 2 * kPatterns + 2));
        random += alienation_of(truth, in_random_order(plan, rater, 2 * kPatterns + 2));
    }
    MESSAGE("K adaptive " << adaptive / kStudies << ", random " << random / kStudies);
    CHECK(adaptive < random);
}

TEST_CASE("adaptive order: the indicator waits for the map, and comes with steady answers") {
    const Flat truth = flat_map(3);
    const SyntheticRater rater{{3.0, 0.0, 0.0, 0.0, 3}, truth.distance, 1};
    const TrialPlan plan{kPatterns, 4, 0, 3};
    const auto answers = answered(plan, rater, 144);
    CHECK_FALSE(map_settling(kPatterns, std::span(answers).first(20)).is_settled);
    const MapSettling end = map_settling(kPatterns, answers);
    CHECK(end.is_settled);
    CHECK(end.change.size() == 3);
    // Somebody who answers blindly never comes there early.
    const SyntheticRater blind{{3.0, 0.0, 0.0, 1.0, 3}, truth.distance, 1};
    const auto noise = answered(plan, blind, 5 * kPatterns);
    CHECK_FALSE(map_settling(kPatterns, noise).is_settled);
    CHECK(map_settling(3, answers).change.empty());
}

}  // namespace adaptive_order_test
