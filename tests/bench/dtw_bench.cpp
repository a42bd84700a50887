// DTW of envelopes of 1 s at 10 kHz, against the textbook loop in turns with it.
//
// On a processor whose AVX-512 is two halves of a register wide (Zen 4), four pipes and five
// operations a cell allow 3.2 cells a cycle, 16 times the textbook loop's 0.2 (a minimum and a sum,
// 5 cycles, each waiting for the last): the bar of 18 is for processors with whole registers.
#include <limits>
#include <map>
#include <mutex>
#include <random>
#include <string>
#include <thread>
#include <vector>

#include "model/dtw/dtw.h"
#include "model/dtw/dtw_strips.h"
#include "tests/bench/owed.h"
#include "tests/support/dtw_textbook.h"

using namespace tact;
using namespace tact::bench;

namespace {

constexpr std::size_t kSamples = 10'000;
constexpr double kCells = 1e-9 * kSamples * kSamples;  // of one pair, in thousand millions

std::vector<std::vector<double>> envelopes(std::size_t count) {
    std::mt19937_64 random(1);
    std::normal_distribution<double> step(0.0, 0.01);
    std::vector<std::vector<double>> result(count, std::vector<double>(kSamples));
    for (auto& envelope : result) {
        double value = 1.0;
        for (double& sample : envelope) sample = value = std::abs(value + step(random));
    }
    return result;
}

// All pairs of one set, or those of the first pattern with the others.
std::vector<SignalPair> pairs_of(const std::vector<std::vector<double>>& patterns,
                                 bool only_first) {
    std::vector<SignalPair> pairs;
    for (std::size_t i = 0; i < (only_first ? 1 : patterns.size()); ++i) {
        for (std::size_t j = i + 1; j < patterns.size(); ++j) {
            pairs.push_back({patterns[i], patterns[j]});
        }
    }
    return pairs;
}

void sweep_bench(benchmark::State& state, const DtwSweep& sweep, double bar) {
    const auto signals = envelopes(sweep.pairs + 1);
    const auto pairs = pairs_of(signals, true);
    std::vector<double> distances(pairs.size());
    Best textbook;
    Best swept;
    for (auto _ : state) {
        textbook.turn([&] { benchmark::DoNotOptimize(dtw_textbook(signals[0], signals[1])); });
        for (int k = 0; k < 2; ++k) {
            swept.turn([&] { dtw_strips(sweep, pairs, 0.0, distances, {}); });
        }
    }
    if (distances[0] != dtw_textbook(signals[0], signals[1])) state.SkipWithError("other bits");
    const double cells = kCells * static_cast<double>(sweep.pairs);
    const double ratio = (cells / swept.shortest_s) / (kCells / textbook.shortest_s);
    state.counters["Gcell/s"] = cells / swept.shortest_s;
    state.counters["textbook_Gcell/s"] = kCells / textbook.shortest_s;
    state.counters["x_textbook"] = ratio;
    if (bar > 0.0) owe_at_least(state, ratio, bar, "x textbook");
}

// How long the busiest thread computed: what the clock would show on a machine of our own.
double busiest_thread_s(std::span<const SignalPair> pairs, int threads) {
    const auto caller = std::this_thread::get_id();
    const double caller_begin_s = thread_s();
    std::mutex mutex;
    std::map<std::thread::id, double> computed_s;
    const auto after_some = [&](double) {
        const std::scoped_lock lock(mutex);
        const auto thread = std::this_thread::get_id();
        computed_s[thread] = thread_s() - (thread == caller ? caller_begin_s : 0.0);
    };
    dtw(pairs, {.threads = threads, .progress = after_some});
    double longest_s = 0.0;
    for (const auto& [thread, seconds] : computed_s) longest_s = std::max(longest_s, seconds);
    return longest_s;
}

double best_of_busiest_s(benchmark::State& state, std::span<const SignalPair> pairs, int threads) {
    double best_s = std::numeric_limits<double>::infinity();
    for (auto _ : state) best_s = std::min(best_s, busiest_thread_s(pairs, threads));
    return best_s;
}

void all_pairs_on_one_core(benchmark::State& state) {
    const auto patterns = envelopes(12);
    owe_at_most(state, best_of_busiest_s(state, pairs_of(patterns, false), 1), 0.5, "s");
}

void one_edited(benchmark::State& state) {
    const auto patterns = envelopes(12);
    owe_at_most(state, best_of_busiest_s(state, pairs_of(patterns, true), 0), 0.1, "s");
}

void two_threads(benchmark::State& state) {
    const auto patterns = envelopes(12);
    const auto pairs = pairs_of(patterns, false);
    double one_s = std::numeric_limits<double>::infinity();
    double two_s = one_s;
    for (auto _ : state) {
        one_s = std::min(one_s, busiest_thread_s(pairs, 1));
        two_s = std::min(two_s, busiest_thread_s(pairs, 2));
    }
    owe_at_least(state, one_s / two_s, 1.8, "x one thread");
}

double bar_of(const std::string& kernel) {
    if (kernel == "avx512") return 18.0;
    return kernel == "avx2" ? 9.0 : 0.0;
}

const bool kRegistered = [] {
    for (const DtwKernel& kernel : dtw_kernels()) {
        const std::string name = std::string("dtw/") + kernel.name;
        benchmark::RegisterBenchmark((name + "/pair_per_lane").c_str(), [&](auto& state) {
            sweep_bench(state, kernel.many_pairs, bar_of(kernel.name));
        })->Iterations(5);
        benchmark::RegisterBenchmark((name + "/one_pair").c_str(), [&](auto& state) {
            sweep_bench(state, kernel.one_pair, 0.0);
        })->Iterations(5);
    }
    return true;
}();

}  // namespace

BENCHMARK(all_pairs_on_one_core)->Name("dtw/12_patterns/one_core")->Iterations(5);
BENCHMARK(one_edited)->Name("dtw/12_patterns/one_edited")->UseRealTime()->Iterations(10);
BENCHMARK(two_threads)->Name("dtw/12_patterns/two_threads")->UseRealTime()->Iterations(5);
