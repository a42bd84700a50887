// A question to the model, as a room asks it: work in the background, what it was asked last, and
// what it has found. The first question begins the work, and the destructor ends it.
//
// Work is no value, the state around it is one. So a copy of a state is what was found, without
// the work: what pictures are drawn from. And a state that another is assigned to keeps its work,
// which forgets: what a room begins again with when another document takes the place of its own.
//
// Input     requests, and the work that answers them, of which the first is kept. Work owns what it
//           uses, so that states may be destroyed in any order
// Output    answers as immutable snapshots (latest_job.h); before the first question, none
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "app/jobs/latest_job.h"

namespace tact {

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
