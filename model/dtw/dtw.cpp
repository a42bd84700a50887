#include "model/dtw/dtw.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <limits>
#include <mutex>

#include "model/common/parallel.h"
#include "model/dtw/dtw_batches.h"
#include "model/dtw/dtw_strips.h"

namespace tact {

namespace {

// Fewer cells than this are done before several threads have met often enough: some 0.1 s.
constexpr double kLongCells = 1e9;

}  // namespace

double dtw(std::span<const double> a, std::span<const double> b, std::stop_token stop) {
    const SignalPair pair = trimmed({a, b}, 0.0).signals;
    double distance = 0.0;
    dtw_strips(dtw_kernel().one_pair, {&pair, 1}, 0.0, {&distance, 1}, stop);
    return distance;
}

std::vector<double> dtw(std::span<const SignalPair> pairs, const DtwOptions& options,
                        const DtwKernel& kernel) {
    const std::vector<TrimmedPair> own = trimmed(pairs, options.waiting_cost);
    const auto threads = static_cast<std::size_t>(thread_count(options.threads));
    const DtwBatches batches = dtw_batches(own, kernel, threads);
    double whole = 0.0;
    for (const DtwBatch& batch : batches.all) whole += batch.cost;

    std::vector<double> distances(pairs.size(), std::numeric_limits<double>::infinity());
    std::mutex mutex;  // guards the next two, so that progress never goes back
    double done = 0.0;
    std::size_t batches_done = 0;
    const auto compute = [&](const DtwBatch& batch, int batch_threads) {
        const auto places = std::span(batches.order).subspan(batch.first, batch.count);
        std::vector<SignalPair> together;
        for (const std::size_t place : places) together.push_back(own[place].signals);
        std::vector<double> found(batch.count);
        dtw_strips(batch.side_by_side ? kernel.many_pairs : kernel.one_pair, together,
                   options.waiting_cost, found, options.stop, batch_threads);
        for (std::size_t k = 0; k < batch.count; ++k) distances[places[k]] = found[k];
        if (!options.progress) return;
        const std::lock_guard lock(mutex);
        done += batch.cost;
        // Sums in another order may miss 1 by a rounding.
        const bool is_last = ++batches_done == batches.all.size();
        options.progress(is_last ? 1.0 : std::min(done / whole, 1.0));
    };
    // While one thread computed one of the longest, the others would be out of work.
    std::size_t first = 0;
    double left = whole;
    while (threads > 1 && first < batches.all.size() && !options.stop.stop_requested()) {
        const double cost = batches.all[first].cost;
        if (cost < kLongCells || cost * static_cast<double>(threads) < 1.5 * left) break;
        compute(batches.all[first++], static_cast<int>(threads));
        left -= cost;
    }
    parallel_for(batches.all.size() - first, options.threads, options.stop,
                 [&](std::size_t t) { compute(batches.all[first + t], 1); });
    return distances;
}

namespace {

enum Step : std::uint8_t { diagonal, down, right };

}  // namespace

DtwPath dtw_path(std::span<const double> a, std::span<const double> b, double waiting_cost) {
    assert(a.empty() == b.empty() && "a way needs two signals");
    DtwPath path;
    if (a.empty() || b.empty()) return path;
    const std::size_t n = b.size();
    std::vector<std::uint8_t> came(a.size() * n, diagonal);
    constexpr double kNowhere = std::numeric_limits<double>::infinity();
    std::vector<double> above(n + 1, kNowhere);  // D[i-1, j-1] at j
    std::vector<double> row(n + 1, kNowhere);
    above[0] = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        row[0] = kNowhere;
        for (std::size_t j = 0; j < n; ++j) {
            double least = above[j];
            Step step = diagonal;
            const double down_to = above[j + 1] + waiting_cost;
            const double right_to = row[j] + waiting_cost;
            if (down_to < least) {
                least = down_to;
                step = down;
            }
            if (right_to < least) {
                least = right_to;
                step = right;
            }
            row[j + 1] = std::abs(a[i] - b[j]) + least;
            came[i * n + j] = step;
        }
        std::swap(above, row);
    }
    path.distance = above[n];
    std::size_t i = a.size() - 1;
    std::size_t j = n - 1;
    for (;;) {
        path.steps.emplace_back(i, j);
        if (i == 0 && j == 0) break;
        const std::uint8_t step = came[i * n + j];
        if (step != right) --i;
        if (step != down) --j;
    }
    std::ranges::reverse(path.steps);
    return path;
}

}  // namespace tact
