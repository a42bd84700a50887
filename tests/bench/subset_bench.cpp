// The most distinct subset of many patterns, proven.
#include "model/subset/subset.h"

#include <cmath>

#include "model/common/random.h"
#include "model/map/group_tree.h"
#include "tests/bench/owed.h"

using namespace tact;
using namespace tact::bench;

namespace {

enum class Kind { points, ranks };

// Even in a cube.
std::vector<double> distances_of_points(std::size_t n, std::uint64_t seed) {
    RandomStream random{seed};
    std::vector<double> place(3 * n);
    for (double& value : place) value = next_even(random);
    std::vector<double> result;
    for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t j = i + 1; j < n; ++j) {
            result.push_back(std::hypot(place[3 * i] - place[3 * j],
                                        place[3 * i + 1] - place[3 * j + 1],
                                        place[3 * i + 2] - place[3 * j + 2]));
        }
    }
    return result;
}

// Distances in space, or half the ranks of two such: the form of PM.
Dissimilarity instance(Kind kind, std::size_t n, std::uint64_t seed) {
    std::vector<double> a = distances_of_points(n, 2 * seed);
    if (kind == Kind::points) return {n, std::move(a)};
    a = average_ranks(a);
    const std::vector<double> b = average_ranks(distances_of_points(n, 2 * seed + 1));
    for (std::size_t k = 0; k < a.size(); ++k) a[k] = 0.5 * (a[k] + b[k]);
    return {n, std::move(a)};
}

// The slowest of three instances on one core, each at its best of the turns.
void ten_of_many(benchmark::State& state, SubsetObjective objective, Kind kind, double bar_s) {
    constexpr std::uint64_t kInstances = 3;
    const auto n = static_cast<std::size_t>(state.range(0));
    std::vector<Dissimilarity> instances;
    for (std::uint64_t k = 0; k < kInstances; ++k) instances.push_back(instance(kind, n, k + 1));
    SubsetOptions options;
    options.threads = 1;
    std::vector<Best> best(kInstances);
    for (auto _ : state) {
        for (std::size_t k = 0; k < kInstances; ++k) {
            SubsetProof proof = SubsetProof::open;
            best[k].turn([&] {
                proof = most_distinct_subset(instances[k], {10, objective}, options)->proof;
            });
            if (proof != SubsetProof::optimal) state.SkipWithError("not proven");
        }
    }
    double slowest_s = 0.0;
    for (const Best& each : best) slowest_s = std::max(slowest_s, each.shortest_s);
    owe_at_most(state, slowest_s, bar_s, "s");
}

// The tree of groups of many, on one core.
void group_tree_of_ranks(benchmark::State& state, double bar_s) {
    const Dissimilarity apart = instance(Kind::ranks, static_cast<std::size_t>(state.range(0)), 1);
    Best best;
    for (auto _ : state) {
        best.turn([&] { benchmark::DoNotOptimize(group_tree(apart)); });
    }
    owe_at_most(state, best.shortest_s, bar_s, "s");
}

void max_min_points(benchmark::State& state, double bar_s) {
    ten_of_many(state, SubsetObjective::max_min, Kind::points, bar_s);
}

void max_min_ranks(benchmark::State& state, double bar_s) {
    ten_of_many(state, SubsetObjective::max_min, Kind::ranks, bar_s);
}

void max_sum_points(benchmark::State& state, double bar_s) {
    ten_of_many(state, SubsetObjective::max_sum, Kind::points, bar_s);
}

void max_sum_ranks(benchmark::State& state, double bar_s) {
    ten_of_many(state, SubsetObjective::max_sum, Kind::ranks, bar_s);
}

}  // namespace

BENCHMARK_CAPTURE(max_min_points, 100, 0.05)
    ->Name("subset/max_min/points/100")
    ->Arg(100)
    ->Iterations(5);
BENCHMARK_CAPTURE(max_min_ranks, 100, 0.05)
    ->Name("subset/max_min/ranks/100")
    ->Arg(100)
    ->Iterations(5);
BENCHMARK_CAPTURE(max_min_points, 500, 0.5)
    ->Name("subset/max_min/points/500")
    ->Arg(500)
    ->Iterations(2);
BENCHMARK_CAPTURE(max_min_ranks, 500, 0.5)
    ->Name("subset/max_min/ranks/500")
    ->Arg(500)
    ->Iterations(2);
BENCHMARK_CAPTURE(max_min_points, 1000, 2.0)
    ->Name("subset/max_min/points/1000")
    ->Arg(1000)
    ->Iterations(2);
BENCHMARK_CAPTURE(max_min_ranks, 1000, 2.0)
    ->Name("subset/max_min/ranks/1000")
    ->Arg(1000)
    ->Iterations(2);
BENCHMARK_CAPTURE(max_sum_points, 100, 0.5)
    ->Name("subset/max_sum/points/100")
    ->Arg(100)
    ->Iterations(5);
BENCHMARK_CAPTURE(max_sum_ranks, 100, 0.5)
    ->Name("subset/max_sum/ranks/100")
    ->Arg(100)
    ->Iterations(5);
BENCHMARK_CAPTURE(max_sum_points, 500, 30.0)
    ->Name("subset/max_sum/points/500")
    ->Arg(500)
    ->Iterations(2);
BENCHMARK_CAPTURE(group_tree_of_ranks, 2000, 1.0)
    ->Name("subset/group_tree/ranks/2000")
    ->Arg(2000)
    ->Iterations(3);
