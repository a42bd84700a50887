// A job in the state that waits for its answers.
//
// A job is no value, the state around it is one. So a copy of a state is what was found, without
// the work: what pictures are drawn from. And a state that another is assigned to keeps its job,
// which forgets: what a room begins again with when another document takes the place of its own.
#pragma once

#include <memory>
#include <utility>

#include "app/jobs/latest_job.h"

namespace tact {

template <class Request, class Answer>
class OwnedJob : public std::unique_ptr<LatestJob<Request, Answer>> {
    using Pointer = std::unique_ptr<LatestJob<Request, Answer>>;

  public:
    using Pointer::Pointer;
    using Pointer::operator=;

    OwnedJob() = default;
    OwnedJob(OwnedJob&&) noexcept = default;
    OwnedJob& operator=(OwnedJob&&) noexcept = default;
    ~OwnedJob() = default;

    OwnedJob(const OwnedJob& /*other*/) noexcept : Pointer() {}
    OwnedJob& operator=(const OwnedJob& other) {
        if (this != &other && *this) (*this)->forget();
        return *this;
    }
};

}  // namespace tact
