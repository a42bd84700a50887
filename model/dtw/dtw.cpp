#include "model/dtw/dtw.h"

#include <algorithm>
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

}  // namespace tact
