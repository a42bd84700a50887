#include "model/system/kept_threads.h"

#include <algorithm>
#include <system_error>

namespace tact {

void KeptThreads::call(std::size_t others, const std::function<void()>& work) {
    Shared shared{&work, others, 0};
    std::size_t missing = 0;
    {
        const std::lock_guard lock(mutex_);
        missing = others - std::min(others, started_);
        started_ += missing;
        if (others > 0) asking_.push_back(&shared);
    }
    changed_.notify_all();
    start(missing);
    work();
    std::unique_lock lock(mutex_);
    std::erase(asking_, &shared);
    ended_.wait(lock, [&shared] { return shared.running == 0; });
}

// Unlocked: the thread that starts threads may want some itself meanwhile.
void KeptThreads::start(std::size_t count) {
    for (; count > 0; --count) {
        try {
            std::jthread thread([this](const std::stop_token& quit) { run(quit); });
            const std::lock_guard lock(mutex_);
            threads_.push_back(std::move(thread));
        } catch (const std::system_error&) {
            // The system gives no more threads; those that there are do the work.
            const std::lock_guard lock(mutex_);
            started_ -= count;
            return;
        }
    }
}

void KeptThreads::run(const std::stop_token& quit) {
    std::unique_lock lock(mutex_);
    while (changed_.wait(lock, quit, [this] { return !asking_.empty(); })) {
        Shared& shared = *asking_.front();
        if (--shared.wanted == 0) asking_.erase(asking_.begin());
        ++shared.running;
        lock.unlock();
        (*shared.work)();
        lock.lock();
        if (--shared.running == 0) ended_.notify_all();
    }
}

}  // namespace tact
