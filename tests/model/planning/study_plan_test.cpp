#include "model/planning/study_plan.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "model/common/random.h"
#include "model/dissimilarity/correlation.h"
#include "model/map/smacof.h"
#include "tests/support/golden.h"

namespace study_plan_test {

using namespace tact;

namespace {

Dissimilarity of_random_points(std::size_t patterns, std::uint64_t seed) {
    RandomStream random{random_bits(seed, 0)};
    Eigen::MatrixXd points(static_cast<Eigen::Index>(patterns), 3);
    for (Eigen::Index e = 0; e < points.size(); ++e) points.data()[e] = next_normal(random);
    return {patterns, distances(points)};
}

Dissimilarity disturbed(Dissimilarity matrix, double by, std::uint64_t seed) {
    RandomStream random{random_bits(seed, 1)};
    for (double& value : matrix.condensed) value = std::abs(value + by * next_normal(random));
    return matrix;
}

StudyPlan plan_of(double rho, double reliability, std::size_t patterns = 10) {
    const Dissimilarity metric = of_random_points(patterns, 1);
    return {metric, of_random_points(patterns, 2), {rho, reliability, "stated"}, 0};
}

std::vector<PlannedStudy> planned(const StudyPlan& plan, std::vector<std::size_t> people,
                                  std::size_t studies = 60) {
    PlanParams params;
    params.studies = studies;
    params.draws = 100;
    return *planned_studies(plan, people, params);
}

constexpr auto kPeople = static_cast<std::size_t>(Resampled::people);
constexpr auto kBoth = static_cast<std::size_t>(Resampled::both);

}  // namespace

TEST_CASE("plan: rho of the simulated people is what was assumed, less what noise takes") {
    // Without noise, the mean over many worlds is the assumed rho.
    for (const double rho : {0.3, 0.67, 0.9}) {
        const auto all = planned(plan_of(rho, 1.0, 14), {2}, 200);
        CHECK_MESSAGE(std::abs(all[0].rho - rho) < 0.03, all[0].rho << " for " << rho);
    }
    // Noise takes a share: by attenuation sqrt(reliability of the mean), near enough for ranks.
    const auto noisy = planned(plan_of(0.67, 0.4, 14), {4}, 200);
    CHECK(std::abs(noisy[0].reliability - 1.6 / 2.2) < 1e-12);
    CHECK(std::abs(noisy[0].rho - 0.67 * std::sqrt(1.6 / 2.2)) < 0.03);
}

TEST_CASE("plan: more people narrow the interval over people, as one over their root") {
    const auto all = planned(plan_of(0.67, 0.4), {8, 32});
    const double ratio = all[0].half_width[kPeople] / all[1].half_width[kPeople];
    CHECK_MESSAGE(ratio > 1.6, ratio);
    CHECK_MESSAGE(ratio < 3.5, ratio);
    CHECK(all[1].power[kBoth] >= all[0].power[kBoth]);
    // One person has nobody to be compared with.
    const auto alone = planned(plan_of(0.67, 0.4), {1}, 20);
    CHECK(std::isnan(alone[0].half_width[kPeople]));
    CHECK(std::isnan(alone[0].power[kPeople]));
    CHECK_FALSE(std::isnan(alone[0].half_width[0]));
}

TEST_CASE("plan: the interval over both is as wide as the studies scatter" *
          doctest::test_suite("long")) {
    const auto all = planned(plan_of(0.6, 0.3, 12), {6}, 400);
    const double covered = all[0].half_width[kBoth] / (1.96 * all[0].rho_sd);
    // Wider, as the metric's own patterns stay the same from study to study here.
    CHECK_MESSAGE(covered > 0.9, covered);
    CHECK_MESSAGE(covered < 2.2, covered);
}

TEST_CASE("plan: where neither metric is better it is seldom told, and a better one often" *
          doctest::test_suite("long")) {
    // Neither says anything of what is felt: half of the false alarms go the metric's way. Over
    // people alone the patterns are what they are, and on these one of the two is better.
    const auto equal = planned(plan_of(0.0, 0.4, 12), {10}, 400);
    CHECK_MESSAGE(equal[0].power[0] <= 0.06, equal[0].power[0]);
    CHECK_MESSAGE(equal[0].power[kBoth] <= 0.06, equal[0].power[kBoth]);
    CHECK_MESSAGE(equal[0].power[kPeople] > 0.1, equal[0].power[kPeople]);
    const auto better = planned(plan_of(0.8, 0.4, 12), {20}, 200);
    CHECK_MESSAGE(better[0].power[kBoth] > 0.9, better[0].power[kBoth]);
    // A rival that is nearly the metric is not told from it.
    StudyPlan near = plan_of(0.8, 0.4, 12);
    near.rival = disturbed(near.metric, 0.05, 3);
    CHECK(planned(near, {20}, 100)[0].power[kBoth] < 0.5);
}

TEST_CASE("plan: pairs are dealt so that each person has different ones, and all as often") {
    for (const auto& [pairs, people, each] :
         {std::array<std::size_t, 3>{10, 7, 6}, {45, 10, 15}, {6, 5, 6}, {7, 3, 1}, {9, 4, 20}}) {
        CAPTURE(pairs);
        RandomStream random{random_bits(pairs, 0)};
        std::vector<std::size_t> times(pairs);
        for (const std::vector<std::size_t>& hand : dealt_pairs(pairs, people, each, random)) {
            CHECK(hand.size() == std::min(each, pairs));
            CHECK(std::set(hand.begin(), hand.end()).size() == hand.size());
            for (const std::size_t pair : hand) ++times[pair];
        }
        const auto [least, most] = std::ranges::minmax(times);
        CHECK(most - least <= 1);
    }
}

TEST_CASE("plan: who rates few pairs says less, and all pairs are rated") {
    StudyPlan some = plan_of(0.67, 0.4);
    some.pairs = 15;  // of 45: ten people rate each pair three times and more
    const auto few = planned(some, {10});
    const auto all = planned(plan_of(0.67, 0.4), {10});
    CHECK(few[0].half_width[kBoth] > all[0].half_width[kBoth]);
    CHECK(few[0].rho < all[0].rho);
    CHECK_FALSE(std::isnan(few[0].rho));
}

TEST_CASE("plan: the same bits for any number of threads, and nothing once stopped") {
    const StudyPlan plan = plan_of(0.67, 0.4, 6);
    const std::vector<std::size_t> people{3, 5};
    PlanParams one{.studies = 20, .draws = 40, .threads = 1};
    PlanParams three{.studies = 20, .draws = 40, .threads = 3};
    const auto a = *planned_studies(plan, people, one);
    const auto b = *planned_studies(plan, people, three);
    for (std::size_t k = 0; k < people.size(); ++k) {
        CHECK(a[k].rho == b[k].rho);
        CHECK(a[k].half_width[kBoth] == b[k].half_width[kBoth]);
        CHECK(a[k].power == b[k].power);
    }
    std::stop_source source;
    source.request_stop();
    one.stop = source.get_token();
    CHECK_FALSE(planned_studies(plan, people, one));
}

TEST_CASE("plan: a pilot gives back the reliability and the rho that it was made with") {
    const Dissimilarity metric = of_random_points(16, 4);
    RandomStream random{7};
    const double noise = std::sqrt((1.0 - 0.5) / 0.5);
    double mean = 0.0;
    double squares = 0.0;
    for (const double value : metric.condensed) mean += value / 120.0;
    for (const double value : metric.condensed) squares += (value - mean) * (value - mean) / 120.0;
    RatingStudy pilot;
    for (std::size_t k = 0; k < 16; ++k) pilot.labels.push_back(std::to_string(k));
    for (int person = 0; person < 12; ++person) {
        Judgement said{std::to_string(person), metric.condensed};
        for (double& value : said.condensed) {
            value += std::sqrt(squares) * noise * next_normal(random);
        }
        pilot.judgements.push_back(said);
    }
    const auto assumed = assumptions_of(pilot, metric);
    REQUIRE(assumed);
    CHECK(std::abs(assumed->reliability - 0.5) < 0.06);
    CHECK(assumed->rho > 0.93);
    CHECK(assumed->source == "a pilot of 12 people");
    pilot.judgements.resize(1);
    CHECK_FALSE(assumptions_of(pilot, metric));
    RatingStudy at_odds = pilot;
    at_odds.judgements.push_back(pilot.judgements[0]);
    for (double& value : at_odds.judgements[1].condensed) value = -value;
    CHECK_FALSE(assumptions_of(at_odds, metric));
}

TEST_CASE("plan: the fewest people that are enough") {
    std::vector<PlannedStudy> studies(3);
    studies[0].people = 20;
    studies[0].power = {0.9, 0.9, 0.85};
    studies[1].people = 10;
    studies[1].power = {0.9, 0.8, std::nan("")};
    studies[2].people = 15;
    studies[2].power = {0.9, 0.7, 0.8};
    CHECK(*enough_people(studies, Resampled::both, 0.8) == 15);
    CHECK(*enough_people(studies, Resampled::people, 0.8) == 10);
    CHECK_FALSE(enough_people(studies, Resampled::both, 0.99));
}

}  // namespace study_plan_test
