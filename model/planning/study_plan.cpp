#include "model/planning/study_plan.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <mutex>
#include <numbers>
#include <numeric>
#include <utility>

#include "model/common/distributions.h"
#include "model/common/parallel.h"
#include "model/common/portable.h"
#include "model/common/random.h"
#include "model/dissimilarity/correlation.h"
#include "model/map/smacof.h"

namespace tact {

namespace {

using Numbers = std::vector<double>;

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
constexpr double kSignificant = 0.05;

// The normal quantile of every mean rank (Blom 1958), and variance 1.
Numbers normal_scores(std::span<const double> values) {
    Numbers scores = average_ranks(values);
    const auto count = static_cast<double>(scores.size());
    double squares = 0.0;
    for (double& score : scores) {
        const double share = (score - 0.375) / (count + 0.25);
        const double z = two_sided_quantile(std::abs(2.0 * share - 1.0), 0);
        score = share < 0.5 ? -z : z;
        squares += score * score;
    }
    const double sd = std::sqrt(squares / count);
    for (double& score : scores) score = sd > 0.0 ? score / sd : 0.0;
    return scores;
}

// Distances between points that lie anywhere.
Numbers random_distances(std::size_t patterns, RandomStream& random) {
    Eigen::MatrixXd points(static_cast<Eigen::Index>(patterns), 3);
    for (Eigen::Index e = 0; e < points.size(); ++e) points.data()[e] = next_normal(random);
    return distances(points);
}

// What people feel on average, in units of its standard deviation.
Numbers felt(const Numbers& metric, std::size_t patterns, double rho, RandomStream& random) {
    const double w = 2.0 * portable::sin(std::numbers::pi * rho / 6.0);
    const double rest = std::sqrt(std::max(0.0, 1.0 - w * w));
    const Numbers misfit = normal_scores(random_distances(patterns, random));
    Numbers mixed(metric.size());
    for (std::size_t p = 0; p < mixed.size(); ++p) mixed[p] = w * metric[p] + rest * misfit[p];
    return mixed;
}

RatingStudy simulated(const StudyPlan& plan, const Numbers& metric, std::size_t people,
                      RandomStream& random) {
    const std::size_t patterns = plan.metric.size;
    const Numbers truth = felt(metric, patterns, plan.assumed.rho, random);
    const double noise = std::sqrt((1.0 - plan.assumed.reliability) / plan.assumed.reliability);
    const std::size_t rated = plan.pairs == 0 ? truth.size() : std::min(plan.pairs, truth.size());
    RatingStudy study;
    for (std::size_t k = 0; k < patterns; ++k) study.labels.push_back(std::to_string(k));
    for (const std::vector<std::size_t>& hand : dealt_pairs(truth.size(), people, rated, random)) {
        Judgement said{std::to_string(study.judgements.size()), Numbers(truth.size(), kNoRating)};
        for (const std::size_t pair : hand) {
            said.condensed[pair] = truth[pair] + noise * next_normal(random);
        }
        study.judgements.push_back(std::move(said));
    }
    return study;
}

// One study: rho of both, and how sure they and their difference are.
struct Found {
    double rho = kNone;
    double rival = kNone;
    std::array<double, kResampledCount> half_width{};
    std::array<double, kResampledCount> is_told{};  // 1 or 0; NaN: not known
};

Found analysed(const StudyPlan& plan, const RatingStudy& study, std::size_t draws) {
    RatedSet rated;
    rated.people.dissimilarity = mean_ratings(study);
    const std::vector<Dissimilarity> metrics{plan.metric, plan.rival};
    std::vector<Evaluation> evaluations(2);
    for (std::size_t m = 0; m < 2; ++m) {
        evaluations[m].rho = spearman(metrics[m].condensed, rated.people.dissimilarity.condensed);
    }
    UncertaintyParams how;
    how.draws = draws;
    how.map_draws = 0;
    how.threads = 1;
    const Uncertainty sure = uncertainty(study, rated, metrics, evaluations, std::size_t{0}, how);
    Found found{evaluations[0].rho, evaluations[1].rho, {}, {}};
    const MetricDifference& difference = sure.differences.front();
    for (std::size_t r = 0; r < kResampledCount; ++r) {
        // Not cut at 1, as the interval that is printed is.
        found.half_width[r] =
            sure.rho[0].error[r] * two_sided_quantile(0.95, sure.rho[0].freedom[r]);
        const double p = difference.p[r];
        found.is_told[r] =
            std::isnan(p) ? kNone : (p < kSignificant && difference.rho.value > 0.0 ? 1.0 : 0.0);
    }
    return found;
}

// The mean of what more than half know.
double mean_of_most(const Numbers& values) {
    const auto known = std::ranges::count_if(values, [](double v) { return !std::isnan(v); });
    return 2 * static_cast<std::size_t>(known) > values.size() ? mean_known(values) : kNone;
}

PlannedStudy summary(std::size_t people, const PlanAssumptions& assumed,
                     std::span<const Found> studies) {
    const auto column = [studies](auto of) {
        Numbers values;
        for (const Found& one : studies) values.push_back(of(one));
        return values;
    };
    PlannedStudy plan;
    plan.people = people;
    const Numbers rho = column([](const Found& one) { return one.rho; });
    plan.rho = mean_of_most(rho);
    plan.rho_rival = mean_of_most(column([](const Found& one) { return one.rival; }));
    double squares = 0.0;
    double known = 0.0;
    for (const double one : rho) {
        if (std::isnan(one)) continue;
        squares += (one - plan.rho) * (one - plan.rho);
        ++known;
    }
    plan.rho_sd = known > 1.0 ? std::sqrt(squares / (known - 1.0)) : kNone;
    const auto n = static_cast<double>(people);
    plan.reliability = n * assumed.reliability / (1.0 + (n - 1.0) * assumed.reliability);
    for (std::size_t r = 0; r < kResampledCount; ++r) {
        plan.half_width[r] =
            mean_of_most(column([r](const Found& one) { return one.half_width[r]; }));
        // Where an error is not known, a study does not tell.
        const Numbers told = column([r](const Found& one) { return one.is_told[r]; });
        if (std::isnan(mean_of_most(told))) {
            plan.power[r] = kNone;
            continue;
        }
        double count = 0.0;
        for (const double one : told) count += std::isnan(one) ? 0.0 : one;
        plan.power[r] = count / static_cast<double>(told.size());
    }
    return plan;
}

}  // namespace

std::vector<std::vector<std::size_t>> dealt_pairs(std::size_t pairs, std::size_t people,
                                                  std::size_t each, RandomStream& random) {
    std::vector<std::size_t> pack(pairs);
    std::size_t next = pairs;
    std::vector<std::vector<std::size_t>> hands(people);
    for (std::vector<std::size_t>& hand : hands) {
        while (hand.size() < std::min(each, pairs)) {
            if (next == pairs) {
                next_permutation_of(random, pack);
                // What this person has from before the shuffle waits for another one.
                std::ranges::stable_partition(pack, [&hand](std::size_t pair) {
                    return std::ranges::find(hand, pair) == hand.end();
                });
                next = 0;
            }
            hand.push_back(pack[next++]);
        }
    }
    return hands;
}

PlanAssumptions guessed_assumptions() {
    return {0.67, 0.4,
            "a guess: rho of PM's mean over Table 2 of Lim & Park 2023, and a reliability that no "
            "pilot gives"};
}

Expected<PlanAssumptions> assumptions_of(const RatingStudy& pilot, const Dissimilarity& metric) {
    const std::size_t people = participant_means(pilot).size();
    if (people < 2) {
        return Error{"expected a pilot of two people at least, got " + std::to_string(people)};
    }
    const Reliability alike = reliability(pilot);
    if (!(alike.spearman_brown > 0.0)) {
        return Error{
            "expected a pilot whose people agree with each other, got a reliability of their mean "
            "of 0 or less"};
    }
    const auto n = static_cast<double>(people);
    const double of_mean = std::min(alike.spearman_brown, 1.0 - 1e-6);
    const double of_one = of_mean / (n - (n - 1.0) * of_mean);
    const double rho = spearman(metric.condensed, mean_ratings(pilot).condensed);
    if (!(rho > 0.0)) {
        return Error{
            "expected a pilot that the metric agrees with, got a rho of 0 or less: state --rho"};
    }
    return PlanAssumptions{std::min(rho / std::sqrt(of_mean), 1.0), of_one,
                           "a pilot of " + std::to_string(people) + " people"};
}

std::optional<std::vector<PlannedStudy>> planned_studies(const StudyPlan& plan,
                                                         std::span<const std::size_t> people,
                                                         const PlanParams& params) {
    const Numbers metric = normal_scores(plan.metric.condensed);
    std::vector<PlannedStudy> all;
    std::mutex reporting;
    std::size_t done = 0;
    const auto whole = static_cast<double>(people.size() * params.studies);
    for (const std::size_t count : people) {
        std::vector<Found> studies(params.studies);
        parallel_for(studies.size(), params.threads, params.stop, [&](std::size_t study) {
            // The same patterns misfit whatever the number of people, so that powers can be
            // compared.
            RandomStream random{random_bits(params.seed, study)};
            studies[study] = analysed(plan, simulated(plan, metric, count, random), params.draws);
            const std::lock_guard lock(reporting);
            ++done;
            if (params.progress) params.progress(static_cast<double>(done) / whole);
        });
        if (params.stop.stop_requested()) return std::nullopt;
        all.push_back(summary(count, plan.assumed, studies));
    }
    return all;
}

std::optional<std::size_t> enough_people(std::span<const PlannedStudy> studies, Resampled by,
                                         double share) {
    std::optional<std::size_t> fewest;
    for (const PlannedStudy& one : studies) {
        const bool is_enough = one.power[static_cast<std::size_t>(by)] >= share;
        if (is_enough && (!fewest || one.people < *fewest)) fewest = one.people;
    }
    return fewest;
}

}  // namespace tact
