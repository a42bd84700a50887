#include "model/dtw/dtw.h"

#include <algorithm>
#include <atomic>
#include <limits>
#include <numeric>
#include <utility>

#include "model/common/parallel.h"
#include "model/dtw/dtw_strips.h"

namespace tact {

namespace {

// What a pair by itself costs where one of many side by side costs 1: 1.2 (baseline), 1.3 (AVX-512)
// and 1.6 (AVX2) measured on Zen 4. It decides who computes a pair, not what comes out.
constexpr double kCostOfOne = 1.4;

// Some pairs of one shape, computed together.
struct Task {
    std::size_t first = 0;  // position in by_shape
    std::size_t count = 0;
    bool side_by_side = false;
};

std::pair<std::size_t, std::size_t> shape(const SignalPair& pair) {
    return {pair.a.size(), pair.b.size()};
}

// Pairs of one shape next to each other, the longest first.
std::vector<std::size_t> by_shape(std::span<const SignalPair> pairs) {
    std::vector<std::size_t> order(pairs.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::stable_sort(order, std::greater{}, [&](std::size_t k) { return shape(pairs[k]); });
    return order;
}

// How long the busiest thread works if so many full registers are taken and the rest one by one.
double time_taken(std::size_t pairs, std::size_t lanes, std::size_t registers,
                  std::size_t threads) {
    const auto register_cost = static_cast<double>(lanes);
    const std::size_t rounds = registers / threads;
    double time = register_cost * static_cast<double>(rounds);
    std::size_t singles = pairs - std::min(pairs, registers * lanes);
    // While some threads have a register more than the others, those take pairs one by one.
    if (const std::size_t busier = registers % threads; busier > 0) {
        const auto meanwhile = static_cast<std::size_t>(register_cost / kCostOfOne);
        singles -= std::min(singles, meanwhile * (threads - busier));
        time += register_cost;
    }
    const std::size_t single_rounds = (singles + threads - 1) / threads;
    return time + kCostOfOne * static_cast<double>(single_rounds);
}

// A register of pairs keeps one thread busy for long: with few pairs some are better taken alone.
std::size_t best_registers(std::size_t pairs, std::size_t lanes, std::size_t threads) {
    std::size_t best = 0;
    for (std::size_t registers = 1; registers <= (pairs + lanes - 1) / lanes; ++registers) {
        const double time = time_taken(pairs, lanes, registers, threads);
        if (time <= time_taken(pairs, lanes, best, threads)) best = registers;
    }
    return best;
}

std::vector<Task> tasks_of(std::span<const SignalPair> pairs, std::span<const std::size_t> order,
                           std::size_t lanes, std::size_t threads) {
    std::vector<Task> tasks;
    for (std::size_t first = 0; first < order.size();) {
        std::size_t end = first + 1;
        while (end < order.size() && shape(pairs[order[end]]) == shape(pairs[order[first]])) ++end;
        for (auto left = best_registers(end - first, lanes, threads); left > 0; --left) {
            tasks.push_back({first, std::min(lanes, end - first), true});
            first += tasks.back().count;
        }
        for (; first < end; ++first) tasks.push_back({first, 1, false});
    }
    return tasks;
}

}  // namespace

double dtw(std::span<const double> a, std::span<const double> b, std::stop_token stop) {
    const SignalPair pair{a, b};
    double distance = 0.0;
    dtw_strips(dtw_kernel().one_pair, {&pair, 1}, 0.0, {&distance, 1}, stop);
    return distance;
}

std::vector<double> dtw(std::span<const SignalPair> pairs, const DtwOptions& options,
                        const DtwKernel& kernel) {
    const auto order = by_shape(pairs);
    const auto threads = static_cast<std::size_t>(thread_count(options.threads));
    const auto tasks = tasks_of(pairs, order, kernel.many_pairs.pairs, threads);
    std::vector<double> distances(pairs.size(), std::numeric_limits<double>::infinity());
    std::atomic<std::size_t> done{0};
    parallel_for(tasks.size(), options.threads, options.stop, [&](std::size_t t) {
        const Task& task = tasks[t];
        const auto places = std::span(order).subspan(task.first, task.count);
        std::vector<SignalPair> together;
        for (const std::size_t place : places) together.push_back(pairs[place]);
        std::vector<double> found(task.count);
        dtw_strips(task.side_by_side ? kernel.many_pairs : kernel.one_pair, together,
                   options.waiting_cost, found, options.stop);
        for (std::size_t k = 0; k < task.count; ++k) distances[places[k]] = found[k];
        const std::size_t so_far = done += task.count;
        if (options.progress) {
            options.progress(static_cast<double>(so_far) / static_cast<double>(pairs.size()));
        }
    });
    return distances;
}

}  // namespace tact
