// Work that nothing stops and that is waited for at the end, such as writing a file.
#pragma once

#include <chrono>
#include <future>
#include <utility>

#include "app/jobs/turns.h"

namespace tact {

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

}  // namespace tact
