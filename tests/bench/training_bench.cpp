// The paper's whole grid of parameters on as many patterns as its sets have, on one core, against
// the obvious way: a form for squared NC, and sorting for every rank.
//
// That way has no reason to leave out weights in the same proportion; how much faster the search is
// on those that differ alone stands beside it. Its time is that of a sample of the grid.
#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "tests/bench/owed.h"
#include "tests/support/training_problem.h"

using namespace tact;
using namespace tact::bench;

namespace {

constexpr std::array<std::size_t, 6> kPatterns{8, 14, 7, 7, 7, 15};
constexpr int kUnits = 10;

struct Question {
    SearchProblem problem;  // the mean over the sets, and over all but each
    std::vector<std::vector<double>> ratings;
};

Question six_sets() {
    RandomStream random{8};
    Question of;
    std::vector<ColumnPlace> all;
    for (const std::size_t patterns : kPatterns) {
        of.problem.sets.push_back(random_set(random, patterns, 400));
        of.ratings.push_back(random_ratings(random, pair_count(patterns)));
        all.push_back(*add_ratings(of.problem, of.ratings.size() - 1, of.ratings.back()));
    }
    of.problem.objectives.push_back(all);
    for (std::size_t s = 0; s < all.size(); ++s) {
        std::vector<ColumnPlace> others = all;
        others.erase(others.begin() + static_cast<std::ptrdiff_t>(s));
        of.problem.objectives.push_back(others);
    }
    return of;
}

// Average ranks by sorting keys with their places.
void sort_ranks(const std::vector<std::int64_t>& values, std::vector<std::uint64_t>& keys,
                std::vector<double>& ranks) {
    keys.resize(values.size());
    ranks.resize(values.size());
    for (std::size_t k = 0; k < values.size(); ++k) {
        keys[k] = static_cast<std::uint64_t>(values[k]) << 32U | k;
    }
    std::ranges::sort(keys);
    for (std::size_t first = 0; first < keys.size();) {
        std::size_t end = first + 1;
        while (end < keys.size() && keys[end] >> 32U == keys[first] >> 32U) ++end;
        const double rank = static_cast<double>(first + 1 + end) / 2.0;
        for (std::size_t k = first; k < end; ++k) ranks[keys[k] & 0xffffffffU] = rank;
        first = end;
    }
}

double pearson(const std::vector<double>& a, const std::vector<double>& b) {
    const double mean = (static_cast<double>(a.size()) + 1.0) / 2.0;
    double ab = 0.0;
    double aa = 0.0;
    double bb = 0.0;
    for (std::size_t k = 0; k < a.size(); ++k) {
        ab += (a[k] - mean) * (b[k] - mean);
        aa += (a[k] - mean) * (a[k] - mean);
        bb += (b[k] - mean) * (b[k] - mean);
    }
    return ab / std::sqrt(aa * bb);
}

// One weight for every channel, all mixtures; returns how many combinations that are.
std::size_t by_sorting(const Question& of, const std::vector<std::vector<double>>& rated,
                       const ChannelUnits& w, double& best) {
    std::vector<std::uint64_t> keys;
    std::vector<std::int64_t> values;
    std::vector<double> pm;
    std::vector<std::vector<double>> nc(of.problem.sets.size());
    for (std::size_t s = 0; s < nc.size(); ++s) {
        values.clear();
        for (const SpikeForm& form : of.problem.sets[s].forms.front()) {
            std::int64_t sum = 0;
            for (std::size_t c = 0; c < kReceptorCount; ++c) {
                for (std::size_t d = 0; d < kReceptorCount; ++d) sum += w[c] * w[d] * form[c][d];
            }
            values.push_back(sum);
        }
        sort_ranks(values, keys, nc[s]);
    }
    std::size_t combinations = 0;
    for (int mix = 1; mix < (kUnits + 1) * (kUnits + 1); ++mix) {
        double sum = 0.0;
        for (std::size_t s = 0; s < nc.size(); ++s) {
            const std::vector<double>& oc = of.problem.sets[s].oc_rank;
            values.resize(oc.size());
            for (std::size_t k = 0; k < oc.size(); ++k) {
                const double twice =
                    2.0 * (mix / (kUnits + 1) * nc[s][k] + mix % (kUnits + 1) * oc[k]);
                values[k] = static_cast<std::int64_t>(twice);
            }
            sort_ranks(values, keys, pm);
            sum += pearson(pm, rated[s]);
        }
        best = std::max(best, sum);
        ++combinations;
    }
    return combinations;
}

void whole_grid(benchmark::State& state, const TrainingKernel& kernel, double bar_s,
                double least_ratio) {
    const Question of = six_sets();
    std::vector<std::vector<double>> rated;
    for (const auto& ratings : of.ratings) rated.push_back(average_ranks(ratings));
    const SearchParams params{.units = kUnits, .threads = 1, .kernel = &kernel};
    Best searched;
    Best sorted;
    std::size_t combinations = 0;
    double best = 0.0;
    const auto sort_some = [&] {
        combinations = 0;
        for (int k = 1; k <= 100; ++k) {
            combinations += by_sorting(of, rated, {k % 11, k % 7, k % 5, 1 + k % 9}, best);
        }
    };
    double rho = 0.0;
    for (auto _ : state) {
        sorted.turn(sort_some);
        searched.turn([&] { rho = search(of.problem, params)->optima.front().value; });
        sorted.turn(sort_some);
    }
    benchmark::DoNotOptimize(best);
    const double each_s = sorted.shortest_s / static_cast<double>(combinations);
    const TrainingGrid grid = training_grid(kUnits);
    const auto different =
        static_cast<double>(kTrainedLayers * grid.channels.size() * grid.mixes.size());
    const auto all = static_cast<double>(combination_count(kUnits));
    const double ratio = each_s * all / searched.shortest_s;
    state.counters["s"] = searched.shortest_s;
    state.counters["x_sorting"] = ratio;
    state.counters["x_sorting_those_that_differ"] = each_s * different / searched.shortest_s;
    state.counters["rho"] = rho;
    if (least_ratio > 0.0 && ratio < least_ratio) {
        owe_at_least(state, ratio, least_ratio, "x Gram + sort");
    } else if (bar_s > 0.0) {
        owe_at_most(state, searched.shortest_s, bar_s, "s");
    }
}

double bar_s_of(const std::string& kernel) {
    if (kernel == "avx512") return 20.0;
    return kernel == "avx2" ? 40.0 : 0.0;
}

const bool kRegistered = [] {
    for (const TrainingKernel& kernel : training_kernels()) {
        const double bar_s = bar_s_of(kernel.name);
        benchmark::RegisterBenchmark((std::string("training/whole_grid/") + kernel.name).c_str(),
                                     [&kernel, bar_s](auto& state) {
                                         whole_grid(state, kernel, bar_s, bar_s > 0.0 ? 20.0 : 0.0);
                                     })
            ->Iterations(1);
    }
    return true;
}();

}  // namespace
