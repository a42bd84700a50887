#include "model/common/parallel.h"

#include <algorithm>
#include <atomic>
#include <thread>
#include <vector>

namespace tact {

int thread_count(int threads) {
    if (threads > 0) return threads;
    return std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

bool parallel_for(std::size_t count, int threads, std::stop_token stop,
                  const std::function<void(std::size_t)>& work) {
    std::atomic<std::size_t> next{0};
    std::atomic<std::size_t> done{0};
    const auto take_work = [&] {
        while (!stop.stop_requested()) {
            const std::size_t index = next.fetch_add(1);
            if (index >= count) return;
            work(index);
            done.fetch_add(1);
        }
    };
    const auto workers = std::min(static_cast<std::size_t>(thread_count(threads)), count);
    {
        std::vector<std::jthread> others;
        for (std::size_t k = 1; k < workers; ++k) others.emplace_back(take_work);
        take_work();
    }
    return done == count;
}

}  // namespace tact
