#include "model/common/parallel.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>

#include "model/common/processors.h"
#include "model/system/pauses.h"
#include "model/system/together.h"

namespace tact {

namespace {

// The exception of the lowest index of those that threw. Indices are handed out in order, so every
// one below it has been worked on as well: it does not depend on how threads happened to run.
struct Failure {
    std::mutex mutex;
    std::size_t index = 0;
    std::exception_ptr exception;
    std::atomic<bool> is_there{false};

    void keep(std::size_t of_index, std::exception_ptr thrown) {
        const std::scoped_lock lock(mutex);
        if (exception == nullptr || of_index < index) {
            index = of_index;
            exception = std::move(thrown);
        }
        is_there = true;
    }
};

}  // namespace

int thread_count(int threads) {
    if (threads > 0) return threads;
    return usable_processors();
}

bool parallel_for(std::size_t count, int threads, std::stop_token stop,
                  const std::function<void(std::size_t)>& work) {
    std::atomic<std::size_t> next{0};
    std::atomic<std::size_t> done{0};
    Failure failure;
    const auto take_work = [&]() noexcept {
        while (!stop.stop_requested() && !failure.is_there) {
            const std::size_t index = next.fetch_add(1);
            if (index >= count) return;
            try {
                work(index);
                done.fetch_add(1);
            } catch (...) {
                failure.keep(index, std::current_exception());
            }
            pause_if_due();
        }
    };
    const auto workers = std::min(static_cast<std::size_t>(thread_count(threads)), count);
    call_together(workers > 1 ? workers - 1 : 0, take_work);
    if (failure.exception != nullptr) std::rethrow_exception(failure.exception);
    return done == count;
}

}  // namespace tact
