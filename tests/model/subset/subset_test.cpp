#include "model/subset/subset.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <set>
#include <vector>

#include "model/common/random.h"
#include "model/subset/whole_distances.h"
#include "model/subset/widest_set.h"

namespace subset_test {

using namespace tact;

namespace {

using Indices = std::vector<std::size_t>;

// Points at random in a number of dimensions, even in a cube.
Dissimilarity of_points(std::size_t n, int dimensions, std::uint64_t seed) {
    RandomStream random{seed};
    std::vector<std::vector<double>> points(n);
    for (auto& point : points) {
        for (int d = 0; d < dimensions; ++d) point.push_back(next_even(random));
    }
    Dissimilarity result{n, {}};
    for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t j = i + 1; j < n; ++j) {
            double sum = 0.0;
            for (std::size_t d = 0; d < points[i].size(); ++d) {
                sum += (points[i][d] - points[j][d]) * (points[i][d] - points[j][d]);
            }
            result.condensed.push_back(std::sqrt(sum));
        }
    }
    return result;
}

// Half the ranks of two metrics, as PM: many ties.
Dissimilarity of_ranks(std::size_t n, std::uint64_t seed) {
    const std::vector<double> a = average_ranks(of_points(n, 1, seed).condensed);
    const std::vector<double> b = average_ranks(of_points(n, 2, seed + 1).condensed);
    Dissimilarity result{n, {}};
    for (std::size_t k = 0; k < a.size(); ++k) result.condensed.push_back(0.5 * (a[k] + b[k]));
    return result;
}

// Whole numbers of few values: nearly all is tied.
Dissimilarity of_few_values(std::size_t n, std::size_t values, std::uint64_t seed) {
    RandomStream random{seed};
    Dissimilarity result{n, {}};
    for (std::size_t k = 0; k < pair_count(n); ++k) {
        result.condensed.push_back(static_cast<double>(next_index(random, values)));
    }
    return result;
}

struct Instance {
    Dissimilarity dissimilarity;
    SubsetProblem problem;
};

Instance random_instance(std::uint64_t seed) {
    RandomStream random{random_bits(71, seed)};
    Instance instance;
    const std::size_t n = 5 + next_index(random, 9);
    switch (seed % 4) {
        case 0:
            instance.dissimilarity = of_points(n, 3, seed);
            break;
        case 1:
            instance.dissimilarity = of_ranks(n, seed);
            break;
        case 2:
            instance.dissimilarity = of_few_values(n, 2 + next_index(random, 4), seed);
            break;
        default:
            instance.dissimilarity = of_few_values(n, 1000, seed);
    }
    SubsetProblem& problem = instance.problem;
    problem.objective = seed % 8 < 4 ? SubsetObjective::max_min : SubsetObjective::max_sum;
    problem.count = 2 + next_index(random, n - 3);
    Indices order(n);
    next_permutation_of(random, order);
    const std::size_t kept = next_index(random, std::min<std::size_t>(problem.count + 1, 4));
    const std::size_t dropped = next_index(random, std::min<std::size_t>(n - problem.count + 1, 3));
    problem.keep.assign(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(kept));
    problem.drop.assign(order.end() - static_cast<std::ptrdiff_t>(dropped), order.end());
    return instance;
}

// All subsets as asked, the best first; ties by sum and by indices.
std::vector<Subset> by_brute_force(const Instance& instance) {
    const SubsetProblem& problem = instance.problem;
    const std::size_t n = instance.dissimilarity.size;
    const bool by_sum = problem.objective == SubsetObjective::max_sum;
    std::vector<Subset> all;
    for (std::size_t bits = 0; bits < (std::size_t{1} << n); ++bits) {
        Indices members;
        for (std::size_t v = 0; v < n; ++v) {
            if ((bits >> v & 1U) != 0) members.push_back(v);
        }
        const auto holds = [&](std::size_t v) { return (bits >> v & 1U) != 0; };
        if (members.size() != problem.count || !std::ranges::all_of(problem.keep, holds) ||
            std::ranges::any_of(problem.drop, holds)) {
            continue;
        }
        all.push_back(subset_of(instance.dissimilarity, members));
    }
    std::ranges::sort(all, [by_sum](const Subset& a, const Subset& b) {
        constexpr double kRounding = 1e-9;
        if (!by_sum && a.weakest_dissimilarity != b.weakest_dissimilarity) {
            return a.weakest_dissimilarity > b.weakest_dissimilarity;
        }
        if (std::abs(a.sum - b.sum) > kRounding) return a.sum > b.sum;
        return a.members < b.members;
    });
    return all;
}

SubsetAnswer answer_to(const Instance& instance, const SubsetOptions& options = {}) {
    const auto answer = most_distinct_subset(instance.dissimilarity, instance.problem, options);
    REQUIRE_MESSAGE(answer, answer.error().message);
    return *answer;
}

}  // namespace

TEST_CASE("subset: on 200 random instances with ties and locks it is that of brute force") {
    for (std::uint64_t seed = 0; seed < 200; ++seed) {
        CAPTURE(seed);
        const Instance instance = random_instance(seed);
        const std::vector<Subset> all = by_brute_force(instance);
        SubsetOptions options;
        options.alternatives = 5;
        options.threads = 1;
        const SubsetAnswer answer = answer_to(instance, options);
        CHECK(answer.proof == SubsetProof::optimal);
        CHECK(answer.best == all.front());
        CHECK(answer.are_alternatives_proven);
        REQUIRE(answer.alternatives.size() == std::min<std::size_t>(5, all.size() - 1));
        for (std::size_t k = 0; k < answer.alternatives.size(); ++k) {
            CAPTURE(k);
            CHECK(answer.alternatives[k] == all[k + 1]);
        }
    }
}

TEST_CASE("subset: two corners of a square are farthest apart, and their opposite is as good") {
    // 0 1
    // 3 2
    const double diagonal = std::sqrt(2.0);
    const Instance instance{{4, {1.0, diagonal, 1.0, 1.0, diagonal, 1.0}}, {2}};
    SubsetOptions options;
    options.alternatives = 2;
    const SubsetAnswer answer = answer_to(instance, options);
    CHECK(answer.best.members == Indices{0, 2});
    CHECK(answer.bound == diagonal);
    REQUIRE(answer.alternatives.size() == 2);
    CHECK(answer.alternatives[0].members == Indices{1, 3});
    CHECK(answer.alternatives[1].weakest_dissimilarity == 1.0);
}

TEST_CASE("subset: the largest sum may hold near duplicates where the widest pair does not") {
    // Two pairs of twins far apart, and one between them.
    const Dissimilarity line = [] {
        const std::vector<double> x{0.0, 0.1, 5.0, 9.9, 10.0};
        Dissimilarity result{5, {}};
        for (std::size_t i = 0; i < 5; ++i) {
            for (std::size_t j = i + 1; j < 5; ++j) result.condensed.push_back(x[j] - x[i]);
        }
        return result;
    }();
    CHECK(answer_to({line, {3}}).best.members == Indices{0, 2, 4});
    CHECK(answer_to({line, {4, SubsetObjective::max_sum}}).best.members == Indices{0, 1, 3, 4});
}

TEST_CASE("subset: where all are equally far apart the first ones are picked, at once") {
    Dissimilarity equal{200, std::vector<double>(pair_count(200), 3.0)};
    for (const auto objective : {SubsetObjective::max_min, SubsetObjective::max_sum}) {
        SubsetProblem problem{5, objective, {17}, {1}};
        const SubsetAnswer answer = answer_to({equal, problem});
        CHECK(answer.proof == SubsetProof::optimal);
        CHECK(answer.best.members == Indices{0, 2, 3, 4, 17});
        CHECK(answer.best.sum == 30.0);
    }
}

TEST_CASE("subset: moving one object alone away never makes the best weakest pair closer") {
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
        Dissimilarity near = of_points(30, 3, seed);
        const double before = answer_to({near, {6}}).best.weakest_dissimilarity;
        for (std::size_t j = 0; j < 30; ++j) {
            if (j != 7)
                near.condensed[pair_index(30, std::min<std::size_t>(j, 7),
                                          std::max<std::size_t>(j, 7))] += 0.2;
        }
        CHECK(answer_to({near, {6}}).best.weakest_dissimilarity >= before);
    }
}

TEST_CASE("subset: the same on one, two and four threads") {
    for (const auto objective : {SubsetObjective::max_min, SubsetObjective::max_sum}) {
        const Instance instance{of_ranks(60, 5), {8, objective, {3}, {4}}};
        SubsetOptions options;
        options.alternatives = 4;
        options.threads = 1;
        const SubsetAnswer one = answer_to(instance, options);
        CHECK(one.proof == SubsetProof::optimal);
        for (const int threads : {2, 4}) {
            options.threads = threads;
            CHECK(answer_to(instance, options) == one);
        }
    }
}

TEST_CASE("subset: past its time it is not called optimal, and its bound is above the true one") {
    for (const auto objective : {SubsetObjective::max_min, SubsetObjective::max_sum}) {
        const Instance instance{of_ranks(80, 9), {9, objective}};
        const SubsetAnswer truth = answer_to(instance);
        REQUIRE(truth.proof == SubsetProof::optimal);
        SubsetOptions options;
        options.time_limit_s = 0.0;
        options.alternatives = 3;
        const SubsetAnswer cut = answer_to(instance, options);
        CHECK(cut.proof != SubsetProof::optimal);
        CHECK(cut.best.members.size() == 9);
        const bool by_sum = objective == SubsetObjective::max_sum;
        CHECK(cut.bound >= (by_sum ? truth.best.sum : truth.best.weakest_dissimilarity));
        CHECK(cut.bound >= (by_sum ? cut.best.sum : cut.best.weakest_dissimilarity));

        std::stop_source stop;
        stop.request_stop();
        SubsetOptions stopped;
        stopped.stop = stop.get_token();
        CHECK(answer_to(instance, stopped).proof != SubsetProof::optimal);
    }
}

TEST_CASE("subset: of many patterns no bound is begun that could not end in time") {
    // The eigenvalues of this many take minutes, and are not to be stopped on the way.
    const Instance instance{of_points(2'500, 3, 5), {8, SubsetObjective::max_sum}};
    SubsetOptions options;
    options.time_limit_s = 0.0;
    const SubsetAnswer cut = answer_to(instance, options);
    CHECK(cut.proof == SubsetProof::open);
    CHECK(cut.best.members.size() == 8);
    CHECK(cut.bound >= cut.best.sum);
    CHECK(std::isfinite(cut.bound));
}

TEST_CASE("subset: the curve falls with k, and each point is that of its own search") {
    const Dissimilarity dissimilarity = of_ranks(24, 3);
    const SubsetProblem problem{5, SubsetObjective::max_sum, {2, 9}, {0}};
    const std::vector<CurvePoint> curve = weakest_by_count(dissimilarity, problem, 100);
    REQUIRE(curve.size() == 22);  // 2 to 23
    CHECK(curve.front().weakest == dissimilarity(2, 9));
    for (std::size_t k = 0; k < curve.size(); ++k) {
        CAPTURE(k);
        SubsetProblem own = problem;
        own.objective = SubsetObjective::max_min;
        own.count = curve[k].count;
        CHECK(curve[k].count == k + 2);
        CHECK(curve[k].weakest == answer_to({dissimilarity, own}).best.weakest_dissimilarity);
        CHECK(curve[k].bound == curve[k].weakest);
        if (k > 0) CHECK(curve[k].weakest <= curve[k - 1].weakest);
    }
}

TEST_CASE("subset: what cannot be is refused in words") {
    const Dissimilarity line{3, {1.0, 2.0, 1.0}};
    const auto words = [&](const SubsetProblem& problem) {
        const auto answer = most_distinct_subset(line, problem);
        return answer ? std::string() : answer.error().message;
    };
    CHECK(words({1}) == "1 to pick: expected at least 2");
    CHECK(words({4}) == "4 to pick of 3: expected at most as many");
    CHECK(words({3, SubsetObjective::max_min, {}, {1, 1}}) ==
          "3 to pick of 2: expected at most as many");
    CHECK(words({2, SubsetObjective::max_min, {0, 1, 2}}) == "2 to pick, but 3 must be kept");
    CHECK(words({2, SubsetObjective::max_min, {1}, {1}}) ==
          "one pattern cannot be both kept and dropped");
    CHECK(words({2, SubsetObjective::max_min, {3}}) == "only 3 patterns are there to pick from");
    CHECK(words({2, SubsetObjective::max_min, {0, 1}}).empty());
}

TEST_CASE("subset: a pair that nobody rated counts as alike") {
    const double unrated = std::numeric_limits<double>::infinity();
    const Instance instance{{3, {unrated, 1.0, 2.0}}, {2}};
    CHECK(answer_to(instance).best.members == Indices{1, 2});
    const Subset both = subset_of(instance.dissimilarity, {0, 1});
    CHECK(both.weakest_dissimilarity == 0.0);
    CHECK(both.sum == 0.0);
}

TEST_CASE("subset: just as far as the weakest pair is far enough of what is kept") {
    const WholeDistances whole = whole_distances({3, {2.0, 1.0, 3.0}});
    const Indices kept{0};
    const Indices others{1, 2};
    CHECK(far_from_kept({whole, 2, kept, others}, whole(0, 1)) == Indices{1});
    CHECK(far_from_kept({whole, 2, kept, others}, whole(0, 2)) == others);
}

TEST_CASE("whole distances: half ranks of many objects keep their sums and order exactly") {
    const Dissimilarity ranks = of_ranks(300, 2);
    const WholeDistances whole = whole_distances(ranks);
    std::set<double> values;
    for (std::size_t i = 0; i < 300; ++i) {
        for (std::size_t j = 0; j < 300; ++j) {
            if (i < j) values.insert(ranks(i, j));
            CHECK_UNARY(std::ldexp(static_cast<double>(whole(i, j)), whole.exponent) ==
                        ranks(i, j));
        }
    }
    CHECK(distinct_values(whole).size() == values.size());
}

TEST_CASE("subset: a search tells what it has and what nothing exceeds, ever closer together") {
    const Dissimilarity apart = of_points(60, 3, 8);
    for (const SubsetObjective objective : {SubsetObjective::max_min, SubsetObjective::max_sum}) {
        SubsetOptions options;
        options.threads = 1;
        double found = 0.0;
        double bound = std::numeric_limits<double>::infinity();
        int told = 0;
        options.so_far = [&](const SubsetAnswer& now) {
            ++told;
            CHECK(now.proof == SubsetProof::open);
            CHECK(now.best == subset_of(apart, now.best.members));
            CHECK(now.best.members.size() == 6);
            const double worth = worth_of(now.best, objective);
            CHECK(worth >= found);
            CHECK(now.bound <= bound);
            CHECK(worth <= now.bound);
            found = worth;
            bound = now.bound;
        };
        const SubsetAnswer answer =
            *most_distinct_subset(apart, {.count = 6, .objective = objective}, options);
        REQUIRE(answer.proof == SubsetProof::optimal);
        const double best = worth_of(answer.best, objective);
        CHECK(told > 1);  // at once, and later
        CHECK(bound >= best);
        CHECK(found <= best);
    }
}

}  // namespace subset_test
