// Work in the background: a question is asked, and its answer is taken when it is there.
#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <functional>
#include <future>
#include <memory>
#include <mutex>
#include <optional>
#include <stop_token>
#include <string>
#include <thread>
#include <utility>

#include "model/common/expected.h"
#include "model/system/process.h"

namespace tact {

// Turns at the only thread there is: work in the background where a page has no threads of its own.
//
// A job asks for a turn; the window gives one between two frames. So a preview comes while a slider
// moves, and work that a newer request would stop comes once the person rests. Such work pauses for
// frames where the browser can hold it back (model/system/pauses.h); else, and during a preview,
// the picture stands still until it has ended.
//
// Input     jobs that ask; the window, which gives turns
// Output    their work, in the order in which they asked, while other work pauses, too
// Left out  several threads; a stop of work that has begun, unless it pauses or gives its turn
//           back early

// Where the system has no threads (model/system/process.h).
bool work_takes_turns();

// For tests, until the next call: whether threads are left alone though the system has them.
void pretend_no_threads(bool pretend);

enum class TurnKind {
    soon,    // between the next two frames
    at_rest  // once nothing is held, moved or typed
};

class TurnTaker {
  public:
    TurnTaker(TurnKind kind, std::function<void()> work);
    ~TurnTaker();  // asks no more
    TurnTaker(const TurnTaker&) = delete;
    TurnTaker& operator=(const TurnTaker&) = delete;

    // One turn is given for any number of calls before it. Also from its own work.
    void ask();

  private:
    friend bool give_turn(bool at_rest);

    TurnKind kind_;
    std::function<void()> work_;
};

// Does the work of the one who asked first, or begins it; false: nobody did whose turn it is.
bool give_turn(bool at_rest);

// For work that can continue where it was: its turn has been as long as a picture may wait. Never
// where there are threads.
bool is_turn_over();

// Said by work that has kept what it has by now and gives no answer yet.
void want_another_turn();

// Whether it was said since the last call.
bool take_wish_for_turn();

// Work that nothing stops and that is waited for at the end, such as writing a file.

// Beside the window; where there are no threads, by whoever asks for its value.
template <class Work>
auto begun_beside(Work work) {
    const auto how = work_takes_turns() ? std::launch::deferred : std::launch::async;
    return std::async(how, std::move(work));
}

// Its value is there, or is made by asking for it.
template <class Value>
bool has_ended(const std::future<Value>& work) {
    return work.valid() && work.wait_for(std::chrono::seconds(0)) != std::future_status::timeout;
}

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
//           Work may answer in part before it ends: latest() has the newest part until then.
//           What the work throws, such as for want of memory, is no answer; failure() says why
//           Where a page has no threads, the work is done between two frames, in turns
// Left out  queues, several workers (the work itself may use more threads)

enum class JobPolicy {
    finish,    // a running request runs to its end; of those that came meanwhile the newest is next
    supersede  // a newer request stops the running one
};

template <class Request, class Answer>
class LatestJob {
  public:
    // Polls the stop token, sets the progress (0 to 1); no answer when stopped or when it finds
    // none.
    using Work =
        std::function<std::optional<Answer>(const Request&, std::stop_token, std::atomic<float>&)>;

    // The same, and gives what it has by now to the last, as often as it likes.
    using Partly = std::function<void(Answer)>;
    using WorkInParts = std::function<std::optional<Answer>(const Request&, std::stop_token,
                                                            std::atomic<float>&, const Partly&)>;

    // Whether two requests ask for the same work.
    using Same = std::function<bool(const Request& running, const Request& newer)>;

    // `wake` is called on the worker's thread after an answer is there or the work has ended, and
    // must not throw.
    LatestJob(JobPolicy policy, Work work, std::function<void()> wake = {}, Same same = {})
        : LatestJob(
              policy,
              WorkInParts([work = std::move(work)](const Request& request, std::stop_token stop,
                                                   std::atomic<float>& progress, const Partly&) {
                  return work(request, std::move(stop), progress);
              }),
              std::move(wake), std::move(same)) {}

    LatestJob(JobPolicy policy, WorkInParts work, std::function<void()> wake = {}, Same same = {})
        : policy_(policy), worker_(std::make_shared<Worker>()) {
        worker_->work = std::move(work);
        worker_->wake = std::move(wake);
        worker_->same = std::move(same);
        if (work_takes_turns()) {
            const bool waits = policy == JobPolicy::supersede;
            turn_.emplace(waits ? TurnKind::at_rest : TurnKind::soon, [this, worker = worker_] {
                if (worker->take_turn()) turn_->ask();  // not where the job has gone
            });
        } else {
            thread_ = std::jthread([worker = worker_](std::stop_token quit) { worker->run(quit); });
        }
    }

    // The thread then ends as soon as its work heeds the stop. Work that pauses outlives the job.
    ~LatestJob() { cancel(); }

    LatestJob(const LatestJob&) = delete;
    LatestJob& operator=(const LatestJob&) = delete;

    void submit(Request request) {
        const auto run = std::make_shared<const Run>(Run{std::move(request), {}});
        const std::shared_ptr<const Run> running = worker_->replace_waiting(run);
        if (running && policy_ == JobPolicy::supersede && !worker_->is_same_work(*running, *run)) {
            running->stop.request_stop();
        }
        worker_->changed.notify_one();
        if (turn_) turn_->ask();
    }

    // Stops the running request and forgets the waiting one: none of them will be answered.
    void cancel() {
        if (const auto running = worker_->replace_waiting(nullptr)) running->stop.request_stop();
    }

    // Besides, of what was answered nothing is left: latest() is null until the next answer.
    void forget() {
        cancel();
        std::shared_ptr<const Answer> answer;  // freed unlocked
        const std::lock_guard lock(worker_->mutex);
        worker_->latest.swap(answer);
        worker_->failure.clear();
    }

    // Something is running or waiting to run.
    bool busy() const {
        const std::lock_guard lock(worker_->mutex);
        return worker_->running || worker_->waiting;
    }

    // Progress of the running request, 0 to 1.
    float progress() const { return worker_->progress.load(std::memory_order_relaxed); }

    // Why the last request that ended has no answer though nobody stopped it; otherwise empty.
    std::string failure() const {
        const std::lock_guard lock(worker_->mutex);
        return worker_->failure;
    }

    // The newest answer, whole; null before the first.
    std::shared_ptr<const Answer> latest() const {
        const std::lock_guard lock(worker_->mutex);
        return worker_->latest;
    }

  private:
    struct Run {
        Request request;
        mutable std::stop_source stop;  // libc++ stops by a source that may change
    };

    // What the work stands on.
    struct Worker {
        bool is_same_work(const Run& before, const Run& newer) const {
            return same && same(before.request, newer.request);
        }

        // What is running. It is compared and stopped unlocked: a stop calls whatever the work
        // registered for it. The one that waited goes unlocked, too.
        std::shared_ptr<const Run> replace_waiting(std::shared_ptr<const Run> run) {
            const std::lock_guard lock(mutex);
            waiting.swap(run);
            return running;
        }

        void run(const std::stop_token& quit) {
            give_way();
            while (const std::shared_ptr<const Run> one = next(quit)) do_work(*one);
        }

        // Does the one that waits, unless it was cancelled meanwhile. True: another turn is wanted.
        bool take_turn() {
            const std::shared_ptr<const Run> run = begin_waiting();
            if (!run) return false;
            continued = nullptr;
            do_work(*run);
            const bool continues = take_wish_for_turn() && !run->stop.stop_requested();
            if (continues) continued = run;
            const std::lock_guard lock(mutex);
            if (continues && !waiting) waiting = run;
            return waiting != nullptr;
        }

        void do_work(const Run& run) {
            std::string fault;
            std::shared_ptr<const Answer> answer;
            try {
                answer = answer_to(run);
            } catch (...) {
                fault = thrown_error().message;
            }
            publish(answer, fault, run.stop.get_token());
            if (wake) wake();
            // Here goes the answer before this one unless somebody still draws it.
        }

        std::shared_ptr<const Answer> answer_to(const Run& run) {
            const std::stop_token stop = run.stop.get_token();
            const auto partly = [&](Answer part) {
                publish_part(std::make_shared<const Answer>(std::move(part)), stop);
                if (wake) wake();
            };
            std::optional<Answer> answer = work(run.request, stop, progress, partly);
            if (!answer) return nullptr;
            return std::make_shared<const Answer>(*std::move(answer));
        }

        // Waits for a request; null when the job ends.
        std::shared_ptr<const Run> next(const std::stop_token& quit) {
            std::unique_lock lock(mutex);
            if (!changed.wait(lock, quit, [this] { return waiting != nullptr; })) return nullptr;
            return begin();
        }

        // None while another one pauses, which is followed by what came meanwhile.
        std::shared_ptr<const Run> begin_waiting() {
            const std::lock_guard lock(mutex);
            return running ? nullptr : begin();
        }

        // Under the mutex.
        std::shared_ptr<const Run> begin() {
            if (waiting != continued) progress.store(0.0F, std::memory_order_relaxed);
            running = std::exchange(waiting, nullptr);
            return running;
        }

        // After a stop was asked for, an answer may be one to a question nobody asks any more.
        // Gives back what was there before: to be freed unlocked, as that may take longer than a
        // frame.
        void publish(std::shared_ptr<const Answer>& answer, std::string& fault,
                     const std::stop_token& stop) {
            const std::lock_guard lock(mutex);
            running = nullptr;  // the worker still holds it
            if (stop.stop_requested()) return;
            if (answer) latest.swap(answer);
            failure.swap(fault);
        }

        // The part before it goes unlocked, too.
        void publish_part(std::shared_ptr<const Answer> part, const std::stop_token& stop) {
            const std::lock_guard lock(mutex);
            if (!stop.stop_requested()) latest.swap(part);
        }

        WorkInParts work;
        std::function<void()> wake;
        Same same;
        std::mutex mutex;  // guards the next four; nothing is copied or freed under it
        std::shared_ptr<const Run> waiting;
        std::shared_ptr<const Run> running;
        std::shared_ptr<const Answer> latest;
        std::string failure;
        std::condition_variable_any changed;
        std::atomic<float> progress = 0.0F;
        std::shared_ptr<const Run> continued;  // what the last turn has not finished
    };

    JobPolicy policy_;
    std::shared_ptr<Worker> worker_;
    std::optional<TurnTaker> turn_;  // in the place of the thread
    std::jthread thread_;            // last: is joined before all else goes
};

// A question to the model, as a room asks it: work in the background, what it was asked last, and
// what it has found. The first question begins the work, and the destructor ends it.
//
// Work is no value, the state around it is one. So a copy of a state is what was found, without
// the work: what pictures are drawn from. And a state that another is assigned to keeps its work,
// which forgets: what a room begins again with when another document takes the place of its own.
//
// Input     requests, and the work that answers them, of which the first is kept. Work owns what it
//           uses, so that states may be destroyed in any order
// Output    answers as immutable snapshots; before the first question, none

template <class Request, class Answer>
class Query {
    using Job = LatestJob<Request, Answer>;

  public:
    using Partly = typename Job::Partly;
    using Same = typename Job::Same;

    Query() = default;
    ~Query() = default;
    Query(Query&&) noexcept = default;
    Query& operator=(Query&&) noexcept = default;
    Query(const Query& /*other*/) noexcept {}
    Query& operator=(const Query& other) {
        if (this != &other) forget();
        return *this;
    }

    // Begins the work (see LatestJob); the first question does so by itself.
    template <class Work>
    void begin(const Work& work, const std::function<void()>& wake = {},
               JobPolicy policy = JobPolicy::supersede, const Same& same = {}) {
        if (!job_) job_ = std::make_unique<Job>(policy, work, wake, same);
    }

    // Asks, even what was asked last.
    template <class Work>
    void ask(Request request, const Work& work, const std::function<void()>& wake = {},
             JobPolicy policy = JobPolicy::supersede, const Same& same = {}) {
        begin(work, wake, policy, same);
        asked_ = request;
        job_->submit(std::move(request));
    }

    // To be told in each frame what is wanted: asks what was not asked last. What was cancelled is
    // not asked again until something else is wanted.
    template <class Work>
    void want(std::optional<Request> request, const Work& work,
              const std::function<void()>& wake = {}, JobPolicy policy = JobPolicy::supersede) {
        if (request == asked_) return;
        request ? ask(*std::move(request), work, wake, policy) : leave();
    }

    const std::optional<Request>& asked() const { return asked_; }

    void cancel() {
        if (job_) job_->cancel();
    }
    // Nothing is wanted any more; the newest answer stays.
    void leave() {
        if (asked_) cancel();
        asked_.reset();
    }
    void forget() {
        if (job_) job_->forget();
        asked_.reset();
    }

    bool busy() const { return job_ && job_->busy(); }
    float progress() const { return job_ ? job_->progress() : 0.0F; }

    // Why the last request has no answer; empty while it runs, and when it succeeded.
    std::string failure() const { return job_ && !busy() ? job_->failure() : std::string(); }

    // The newest answer, whatever it answers; null before the first.
    std::shared_ptr<const Answer> latest() const { return job_ ? job_->latest() : nullptr; }

    // The answer to what was asked last; null until it is there.
    std::shared_ptr<const Answer> current() const {
        auto answer = latest();
        return answer && asked_ && answer->request == *asked_ ? answer : nullptr;
    }

  private:
    std::unique_ptr<Job> job_;
    std::optional<Request> asked_;
};

}  // namespace tact
