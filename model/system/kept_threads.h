// Threads that wait for other work once theirs has ended.
//
// They are for a system where a thread takes long to start: a page starts each on its own thread,
// after the picture that this one is drawing.
//
// Left out  order among several that share work at the same time
#pragma once

#include <condition_variable>
#include <cstddef>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace tact {

class KeptThreads {
  public:
    // Calls `work` here and, at the same time, on up to `others` more threads; returns once all
    // calls have ended. Threads that are busy do not help, and new ones are started until there are
    // `others`. From any thread, and from within `work`, which must not throw.
    void call(std::size_t others, const std::function<void()>& work);

  private:
    struct Shared {
        const std::function<void()>* work = nullptr;
        std::size_t wanted = 0;
        std::size_t running = 0;
    };

    void run(const std::stop_token& quit);
    void start(std::size_t count);

    std::mutex mutex_;  // guards the rest
    std::condition_variable_any changed_;
    std::condition_variable ended_;
    std::vector<Shared*> asking_;  // that still want threads, in the order in which they asked
    std::size_t started_ = 0;
    std::vector<std::jthread> threads_;  // last: they end before what they use
};

}  // namespace tact
