#include "model/evaluation/evaluation.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <utility>

#include "model/common/distributions.h"
#include "model/common/parallel.h"
#include "model/evaluation/said_once.h"
#include "model/map/smacof.h"

namespace tact {

namespace {

using Eigen::MatrixXd;

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

// Two different objects on one spot.
bool meet(const MatrixXd& points) {
    const std::vector<double> d = distances(points);
    if (d.empty()) return true;
    const auto [least, most] = std::ranges::minmax(d);
    return least <= 1e-6 * most;
}

void map_as_published(Mapped& mapped, int dimensions) {
    const MatrixXd start = torgerson(mapped.dissimilarity, dimensions);
    mapped.is_failed_start = meet(start);
    if (mapped.is_failed_start) return;
    if (order_pairs(mapped.dissimilarity.condensed).levels < 2) return;
    mapped.published_map =
        smacof(mapped.dissimilarity, start, published_mds_params(dimensions)).points;
}

Mapped mapped(const Dissimilarity& dissimilarity, const EvaluationParams& params) {
    Mapped result{dissimilarity, {}, {}, {}};
    map_as_published(result, params.dimensions);
    MdsParams mds = standard_mds_params(dissimilarity.size, params.dimensions);
    mds.threads = params.threads;
    result.space = nonmetric_mds(dissimilarity, mds);
    if (!has_map(result.space)) return result;
    result.maps.push_back(result.space.points);
    if (result.space.verdict == MdsVerdict::trivial) return result;
    // Descents by order alone would end in the map that this one was taken in place of.
    mds.is_interval = result.space.is_interval;
    std::vector<PerceptualSpace> others(params.spread_starts);
    const auto n = static_cast<Eigen::Index>(dissimilarity.size);
    parallel_for(others.size(), params.threads, {}, [&](std::size_t start) {
        others[start] =
            smacof(dissimilarity, random_start(n, params.dimensions, mds.seed, start + 1), mds);
    });
    for (const PerceptualSpace& other : others) {
        const bool fits = other.stress1 <= result.space.stress1 + params.equal_stress;
        if (fits && has_map(other)) result.maps.push_back(other.points);
    }
    return result;
}

void evaluate_order(const Dissimilarity& metric, const Dissimilarity& ratings,
                    const EvaluationParams& params, Evaluation& result) {
    result.rho = spearman(metric.condensed, ratings.condensed);
    result.tau_b = kendall_tau_b(metric.condensed, ratings.condensed);
    result.rho_p = mantel(ratings, metric, {params.rho_orders, 1, params.threads}).p;
    BootstrapParams bootstrap;
    bootstrap.draws = params.bootstrap_draws;
    bootstrap.threads = params.threads;
    result.rho_interval = bootstrap_interval(metric, ratings, bootstrap);
    if (std::isnan(result.rho)) {
        result.remarks.push_back("no rho: the rated pairs are all equally dissimilar");
    } else if (std::isnan(result.rho_interval.low)) {
        result.remarks.push_back(
            "no interval: no other patterns move rho, or most leave it undefined");
    }
}

void evaluate_shape(const Mapped& metric, const RatedSet& rated, const EvaluationParams& params,
                    Evaluation& result) {
    const MatrixXd& people = rated.people.maps.front();
    const MatrixXd& own = metric.maps.front();
    const auto k = alienation(own, people);
    const auto k_procrustes = alienation_procrustes(own, people);
    const auto test = alienation_test(people, own, {params.k_orders, 6, params.threads});
    const auto fit = protest(people, own, {params.k_orders, 6, params.threads});
    if (!k || !k_procrustes || !test || !fit) return;
    result.k = *k;
    result.k_procrustes = *k_procrustes;
    result.protest_p = fit->p;
    result.k_p = test->p;
    result.k_corrected = corrected_alienation(*k, rated.k_chance);
    result.k_spread = {*k, *k};
    for (const MatrixXd& a : metric.maps) {
        for (const MatrixXd& b : rated.people.maps) {
            const auto other = alienation(a, b);
            if (!other) continue;
            ++result.k_maps;
            result.k_spread.low = std::min(result.k_spread.low, *other);
            result.k_spread.high = std::max(result.k_spread.high, *other);
        }
    }
}

// The patterns that some pair was rated with, by their places.
std::vector<std::size_t> places_rated(const Dissimilarity& ratings) {
    std::vector<bool> is_rated(ratings.size, false);
    for (std::size_t p = 0; p < ratings.condensed.size(); ++p) {
        if (!std::isfinite(ratings.condensed[p])) continue;
        const auto [i, j] = pair_at(ratings.size, p);
        is_rated[i] = is_rated[j] = true;
    }
    std::vector<std::size_t> places;
    for (std::size_t k = 0; k < ratings.size; ++k) {
        if (is_rated[k]) places.push_back(k);
    }
    return places;
}

std::string remark_of_failure(const PerceptualSpace& space) {
    if (space.verdict == MdsVerdict::constant) return "no K: equal dissimilarities make no map";
    return "no K: the map is " + remark_on(space);
}

double k_between(const MatrixXd& own, const MatrixXd& people) {
    if (own.size() == 0 || people.size() == 0) return kNone;
    const auto k = alienation(own, people);
    return k ? *k : kNone;
}

}  // namespace

bool has_map(const PerceptualSpace& space) {
    return space.verdict == MdsVerdict::fine || space.verdict == MdsVerdict::trivial;
}

std::string remark_on_people_map(const RatedSet& rated) {
    const Mapped& people = rated_part(rated).people;
    if (people.space.is_interval) {
        return "the map of the ratings: " + remark_on(people.space);
    }
    if (!people.maps.empty()) return {};
    return "no metric has a K, as the map of the ratings is " + remark_on(people.space);
}

Dissimilarity among_rated(const Dissimilarity& all, const RatedSet& rated) {
    return rated.part ? among(all, rated.rated) : all;
}

const RatedSet& rated_part(const RatedSet& rated) { return rated.part ? *rated.part : rated; }

Expected<RatedSet> rated_set(const Dissimilarity& ratings, const EvaluationParams& params) {
    std::vector<std::size_t> places = places_rated(ratings);
    if (!places.empty() && places.size() < ratings.size) {
        Expected<RatedSet> part = rated_set(among(ratings, places), params);
        if (!part) return part;
        auto shared = std::make_shared<const RatedSet>(*std::move(part));
        return RatedSet{mapped(ratings, params), shared->k_chance, shared->random_stress,
                        std::move(places), shared};
    }
    if (ratings.size < 3) {
        return Error{"expected ratings of at least three patterns, got " +
                     std::to_string(ratings.size)};
    }
    if (order_pairs(ratings.condensed).levels < 2) {
        return Error{"expected ratings that differ, got the same for every rated pair"};
    }
    RatedSet rated;
    rated.people = mapped(ratings, params);
    AlienationChanceParams chance;
    chance.draws = params.chance_draws;
    chance.threads = params.threads;
    rated.k_chance = chance_alienation(ratings.size, params.dimensions, chance);
    RandomStressParams random;
    random.draws = params.stress_draws;
    random.threads = params.threads;
    // Beyond this any stress that is worth a look is far below that of random orders.
    if (ratings.size <= 30) {
        rated.random_stress = random_stress(ratings.size, params.dimensions, random);
    } else {
        rated.random_stress = {kNone, {kNone, kNone}};
    }
    return rated;
}

Evaluation evaluate(const Dissimilarity& metric, const RatedSet& rated,
                    const EvaluationParams& params) {
    assert(metric.size == rated.people.dissimilarity.size && "a metric of the rated patterns");
    if (rated.part) return evaluate(among(metric, rated.rated), *rated.part, params);
    Evaluation result;
    evaluate_order(metric, rated.people.dissimilarity, params, result);
    result.k = result.k_p = result.k_corrected = result.k_procrustes = result.protest_p = kNone;
    result.k_spread = {kNone, kNone};
    const Mapped own = mapped(metric, params);
    result.stress1 = own.space.stress1;
    result.is_failed_map = own.maps.empty();
    if (!own.maps.empty()) result.map = own.maps.front();
    result.is_degenerate = own.space.is_degenerate;
    result.published_map = own.published_map;
    result.is_failed_start = own.is_failed_start;
    result.k_published = k_between(own.published_map, rated.people.published_map);
    if (own.maps.empty()) {
        result.stress1 = kNone;
        result.remarks.push_back(remark_of_failure(own.space));
        return result;
    }
    if (own.space.is_interval) result.remarks.push_back(remark_on(own.space));
    if (!rated.people.maps.empty()) evaluate_shape(own, rated, params, result);
    return result;
}

std::vector<std::string> remarks_by_metric(std::span<const std::string> keys,
                                           std::span<const Evaluation> evaluations) {
    assert(keys.size() == evaluations.size() && "a key of each evaluation");
    SaidOnce all;
    for (std::size_t m = 0; m < keys.size(); ++m) {
        for (const std::string& remark : evaluations[m].remarks) all.add(remark, keys[m]);
    }
    std::vector<std::string> lines;
    for (const auto& [remark, of] : all.said) lines.push_back(of + ": " + remark);
    return lines;
}

MeanAgreement mean_agreement(std::span<const Agreement> agreements, Bookkeeping bookkeeping) {
    MeanAgreement mean;
    mean.sets = agreements.size();
    std::vector<double> rho;
    std::vector<double> absolute;
    std::vector<double> k;
    const bool is_paper = bookkeeping == Bookkeeping::paper;
    for (const Agreement& agreement : agreements) {
        if (std::isnan(agreement.rho)) ++mean.undefined_rho;
        if (std::isnan(agreement.k)) ++mean.failed_maps;
        rho.push_back(is_paper && std::isnan(agreement.rho) ? 0.0 : agreement.rho);
        absolute.push_back(std::abs(rho.back()));
        k.push_back(is_paper && std::isnan(agreement.k) ? 1.0 : agreement.k);
    }
    mean.signed_rho = mean_known(rho);
    mean.absolute_rho = mean_known(absolute);
    mean.k = mean_known(k);
    return mean;
}

Agreement agreement_of(const Evaluation& evaluation, Bookkeeping bookkeeping) {
    const bool is_paper = bookkeeping == Bookkeeping::paper;
    return {evaluation.rho, is_paper ? evaluation.k_published : evaluation.k};
}

}  // namespace tact
