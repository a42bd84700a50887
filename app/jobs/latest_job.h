// Work in the background of which only the newest request matters.
//
// Stopping every run for the newest request would show nothing during a long drag; finishing every
// run would lag behind it. Hence two policies, used side by side: a preview that finishes and a
// full run that a newer request stops.
//
// A newer request that asks for the same work, such as of patterns that were only renamed, lets the
// running one come to its end, and follows it: work that keeps its answers then has it at once.
//
// Input     requests, from one thread
// Output    answers as immutable snapshots; latest() at the top of a frame, held while drawing
//           What the work throws, such as for want of memory, is no answer; failure() says why
// Left out  queues, several workers (the work itself may use more threads)
#pragma once

#include <atomic>
#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <stop_token>
#include <string>
#include <thread>
#include <utility>

#include "app/jobs/background.h"
#include "model/common/thrown.h"

namespace tact {

enum class JobPolicy {
    finish,    // a running request runs to its end; of those that came meanwhile the newest is next
    supersede  // a newer request stops the running one
};

template <class Request, class Answer>
class LatestJob {
  public:
    // Polls the stop token, sets the progress (0 to 1); no answer when stopped or when there is
    // none.
    using Work =
        std::function<std::optional<Answer>(const Request&, std::stop_token, std::atomic<float>&)>;

    // Whether two requests ask for the same work.
    using Same = std::function<bool(const Request& running, const Request& newer)>;

    // `wake` is called on the worker's thread after an answer is there or the work has ended.
    LatestJob(JobPolicy policy, Work work, std::function<void()> wake = {}, Same same = {})
        : policy_(policy),
          work_(std::move(work)),
          wake_(std::move(wake)),
          same_(std::move(same)),
          thread_([this](std::stop_token quit) { run(quit); }) {}

    ~LatestJob() { cancel(); }  // the thread then ends as soon as its work heeds the stop

    LatestJob(const LatestJob&) = delete;
    LatestJob& operator=(const LatestJob&) = delete;

    void submit(Request request) {
        const bool stops = policy_ == JobPolicy::supersede && !is_same_work(request);
        const std::stop_source running = replace_waiting(std::move(request));
        if (stops) running.request_stop();
        changed_.notify_one();
    }

    // Stops the running request and forgets the waiting one: none of them will be answered.
    void cancel() { replace_waiting(std::nullopt).request_stop(); }

    // Something is running or waiting to run.
    bool busy() const {
        const std::lock_guard lock(mutex_);
        return is_running_ || waiting_.has_value();
    }

    // Of the running request, 0 to 1.
    float progress() const { return progress_.load(std::memory_order_relaxed); }

    // Why the last request that ended has no answer though nobody stopped it; else empty.
    std::string failure() const {
        const std::lock_guard lock(mutex_);
        return failure_;
    }

    // The newest answer, whole; null before the first.
    std::shared_ptr<const Answer> latest() const {
        const std::lock_guard lock(mutex_);
        return latest_;
    }

  private:
    bool is_same_work(const Request& newer) const {
        if (!same_) return false;
        const std::lock_guard lock(mutex_);
        return is_running_ && same_(*current_, newer);
    }

    // What stops the running request. That is done unlocked: it calls whatever the work registered
    // for a stop.
    std::stop_source replace_waiting(std::optional<Request> request) {
        const std::lock_guard lock(mutex_);
        waiting_ = std::move(request);
        return running_;
    }

    void run(const std::stop_token& quit) {
        give_way_to_interface();
        while (const std::optional<Request> request = next(quit)) {
            const std::stop_token stop = running_.get_token();
            std::string failure;
            std::shared_ptr<const Answer> answer;
            try {
                answer = answer_to(*request, stop);
            } catch (...) {
                failure = thrown_error().message;
            }
            publish(std::move(answer), std::move(failure), stop);
            if (wake_) wake_();
        }
    }

    std::shared_ptr<const Answer> answer_to(const Request& request, const std::stop_token& stop) {
        std::optional<Answer> answer = work_(request, stop, progress_);
        if (!answer) return nullptr;
        return std::make_shared<const Answer>(*std::move(answer));
    }

    // Waits for a request; none when the job ends.
    std::optional<Request> next(const std::stop_token& quit) {
        std::unique_lock lock(mutex_);
        if (!changed_.wait(lock, quit, [this] { return waiting_.has_value(); })) return {};
        running_ = std::stop_source();
        is_running_ = true;
        progress_.store(0.0F, std::memory_order_relaxed);
        current_ = std::exchange(waiting_, std::nullopt);
        return current_;
    }

    // After a stop was asked for, an answer may be one to a question nobody asks any more.
    void publish(std::shared_ptr<const Answer> answer, std::string failure,
                 const std::stop_token& stop) {
        const std::lock_guard lock(mutex_);
        is_running_ = false;
        if (stop.stop_requested()) return;
        if (answer) latest_ = std::move(answer);
        failure_ = std::move(failure);
    }

    JobPolicy policy_;
    Work work_;
    std::function<void()> wake_;
    Same same_;
    mutable std::mutex mutex_;  // guards the next six; never held while the work runs
    std::optional<Request> waiting_;
    std::optional<Request> current_;  // the running one, or the last
    std::stop_source running_;
    bool is_running_ = false;
    std::shared_ptr<const Answer> latest_;
    std::string failure_;
    std::condition_variable_any changed_;
    std::atomic<float> progress_ = 0.0F;
    std::jthread thread_;  // last: starts when all else is there and is joined before it goes
};

}  // namespace tact
