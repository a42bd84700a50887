#include "model/study/pairwise_study.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cstdlib>
#include <map>
#include <set>

#include "model/dissimilarity/dissimilarity.h"

namespace pairwise_study_test {

using namespace tact;

namespace {

std::pair<std::size_t, std::size_t> unordered(const Trial& trial) {
    return std::minmax(trial.left, trial.right);
}

// Left less right, summed over all trials, of every pattern.
std::vector<int> lean(const TrialPlan& plan, const std::vector<Trial>& trials) {
    std::vector<int> sum(plan.patterns, 0);
    for (const Trial& trial : trials) {
        if (trial.is_attention()) continue;
        ++sum[trial.left];
        --sum[trial.right];
    }
    return sum;
}

void check_laws(const TrialPlan& plan) {
    CAPTURE(plan.patterns);
    CAPTURE(plan.repetitions);
    CAPTURE(plan.attention_pairs);
    CAPTURE(plan.seed);
    const std::vector<Trial> trials = trial_list(plan);
    std::map<std::pair<std::size_t, std::size_t>, int> times;
    std::map<std::pair<std::size_t, std::size_t>, int> lower_left;
    int attention = 0;
    for (std::size_t k = 0; k < trials.size(); ++k) {
        REQUIRE(trials[k].left < plan.patterns);
        REQUIRE(trials[k].right < plan.patterns);
        if (trials[k].is_attention()) {
            ++attention;
        } else {
            ++times[unordered(trials[k])];
            lower_left[unordered(trials[k])] += trials[k].left < trials[k].right ? 1 : 0;
        }
        if (k > 0) CHECK(unordered(trials[k]) != unordered(trials[k - 1]));
    }
    CHECK(attention == plan.attention_pairs);
    REQUIRE(times.size() == pair_count(plan.patterns));
    for (const auto& [pair, count] : times) {
        CHECK(count == plan.repetitions);
        CHECK(std::abs(2 * lower_left[pair] - count) <= count % 2);
    }
    for (const int sum : lean(plan, trials)) {
        // An odd number of passes leaves one with n - 1 trials a pattern: odd for even n.
        CHECK(std::abs(sum) <= (plan.repetitions % 2 == 0 || plan.patterns % 2 == 1 ? 0 : 1));
    }
}

}  // namespace

TEST_CASE("pairwise study: every pair as often, sides balanced, none twice in a row, any seed") {
    for (std::size_t patterns = 3; patterns <= 14; ++patterns) {
        for (int repetitions = 1; repetitions <= 5; ++repetitions) {
            for (std::uint64_t seed = 0; seed < 8; ++seed) {
                check_laws({patterns, repetitions, static_cast<int>(seed % 4), seed});
            }
        }
    }
}

TEST_CASE("pairwise study: the publication's twelve patterns make 265 trials of 80 minutes") {
    StudyDesign design;
    design.attention_pairs = 1;
    CHECK(trial_count(design, 12) == 265);
    CHECK(trial_list(plan_of(design, 12, 1)).size() == 265);
    CHECK(predicted_minutes(design, 12, 1.0) == doctest::Approx(80.0).epsilon(0.01));
    CHECK(predicted_minutes(design, 12, 3.0) > predicted_minutes(design, 12, 1.0));
    CHECK(trial_count(design, 1) == 0);
    CHECK(trial_list({1, 4, 1, 1}).empty());
}

TEST_CASE("pairwise study: one seed makes one list, two make two") {
    CHECK(trial_list({12, 4, 1, 7}) == trial_list({12, 4, 1, 7}));
    CHECK(trial_list({12, 4, 1, 7}) != trial_list({12, 4, 1, 8}));
    // These digits must never change: a killed study continues by its seed.
    const std::vector<Trial> first = trial_list({4, 2, 1, 1});
    REQUIRE(first.size() == 13);
    std::string list;
    for (const Trial& trial : first) {
        list += std::to_string(trial.left) + std::to_string(trial.right) + " ";
    }
    CHECK(list == "23 12 20 13 10 30 00 02 21 32 01 03 31 ");
    CHECK(participant_seed(1, "P1") != participant_seed(1, "P2"));
    CHECK(participant_seed(1, "P1") != participant_seed(2, "P1"));
}

TEST_CASE(
    "pairwise study: a pair has either side as often, from pass to pass, as the list has it") {
    const TrialPlan plan{5, 4, 0, 9};
    const std::vector<Trial> trials = trial_list(plan);
    const std::size_t pairs = pair_count(plan.patterns);
    for (std::size_t pair = 0; pair < pairs; ++pair) {
        const auto [i, j] = pair_at(plan.patterns, pair);
        int first_left = 0;
        for (std::size_t pass = 0; pass < 4; ++pass) {
            const Trial trial = sided_trial(plan, pair, pass);
            CHECK(unordered(trial) == std::pair{i, j});
            first_left += trial.left == i ? 1 : 0;
            const auto begin = trials.begin() + static_cast<std::ptrdiff_t>(pass * pairs);
            CHECK(std::find(begin, begin + static_cast<std::ptrdiff_t>(pairs), trial) !=
                  begin + static_cast<std::ptrdiff_t>(pairs));
        }
        CHECK(first_left == 2);
    }
}

TEST_CASE("attention: the chance to pass blindly is that of all ways to answer") {
    const auto counted = [](int pairs, const AttentionRule& rule) {
        std::size_t ways = 1;
        for (int k = 0; k < pairs; ++k) ways *= 101;
        std::size_t passes = 0;
        for (std::size_t way = 0; way < ways; ++way) {
            int missed = 0;
            std::size_t rest = way;
            for (int k = 0; k < pairs; ++k, rest /= 101) {
                missed += static_cast<double>(rest % 101) > rule.above ? 0 : 1;
            }
            passes += missed <= rule.failures_allowed ? 1 : 0;
        }
        return static_cast<double>(passes) / static_cast<double>(ways);
    };
    for (const int pairs : {0, 1, 2, 3}) {
        for (const AttentionRule& rule : {AttentionRule{}, AttentionRule{80.0, 1},
                                          AttentionRule{79.5, 2}, AttentionRule{100.0, 0}}) {
            CAPTURE(pairs);
            CAPTURE(rule.above);
            CHECK(std::abs(chance_to_pass(pairs, rule) - counted(pairs, rule)) < 1e-12);
        }
    }
    CHECK(chance_to_pass(3, {0.0, 100}) == 1.0);
    CHECK(words_on_chance(1, {}) == "20 % of those who answer blindly");
    CHECK(words_on_chance(0, {}) == "100 % of those who answer blindly");
    CHECK(words_on_chance(3, {}) == "0.78 % of those who answer blindly");
}

TEST_CASE("attention: by default several identical pairs, each of another pattern") {
    const StudyDesign design;
    CHECK(chance_to_pass(design.attention_pairs, design.attention) < 0.01);
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        std::set<std::size_t> patterns;
        for (const AttentionPlace& place : attention_places(plan_of(design, 4, seed))) {
            patterns.insert(place.pattern);
        }
        CHECK(patterns.size() == static_cast<std::size_t>(design.attention_pairs));
    }
}

TEST_CASE("pairwise study: attention pairs are spread, and never follow each other") {
    const TrialPlan plan{8, 4, 6, 3};
    const std::vector<AttentionPlace> places = attention_places(plan);
    REQUIRE(places.size() == 6);
    std::set<std::size_t> patterns;
    for (std::size_t k = 0; k < places.size(); ++k) {
        const std::size_t trials = 28 * 4;
        CHECK(places[k].before >= k * trials / 6);
        CHECK(places[k].before < (k + 1) * trials / 6);
        patterns.insert(places[k].pattern);
    }
    CHECK(patterns.size() == 6);
    CHECK(attention_places({3, 1, 50, 1}).size() == 3);  // no more than other trials
}

TEST_CASE("pairwise study: every pattern is trained once, and orders differ between people") {
    std::set<std::vector<std::size_t>> orders;
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        std::vector<std::size_t> order = training_order({12, 4, 1, seed});
        orders.insert(order);
        std::ranges::sort(order);
        for (std::size_t k = 0; k < 12; ++k) CHECK(order[k] == k);
    }
    CHECK(orders.size() == 20);
}

TEST_CASE("pairwise study: the first trial is any pair alike often") {
    std::map<std::pair<std::size_t, std::size_t>, int> first;
    for (std::uint64_t seed = 0; seed < 6000; ++seed) {
        ++first[unordered(trial_list({4, 1, 0, seed}).front())];
    }
    REQUIRE(first.size() == 6);
    for (const auto& [pair, count] : first) CHECK(std::abs(count - 1000) < 150);  // five sigma
}

}  // namespace pairwise_study_test
