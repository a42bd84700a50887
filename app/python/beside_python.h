// Work of the model while Python goes on: its other threads run meanwhile, and Ctrl+C stops it.
//
// Python tells of signals only who asks, and only its main thread: the thread that called asks
// every few hundredths of a second, on behalf of the one that works.
#pragma once

#include <pybind11/pybind11.h>

#include <chrono>
#include <future>
#include <stop_token>
#include <thread>
#include <type_traits>
#include <utility>

namespace tact {

// What work(stop_token) returns, or throws. `work` must not touch Python. Where a signal's handler
// raises (KeyboardInterrupt), the work is stopped, waited for, and that is thrown instead.
template <class Work>
auto beside_python(Work work) {
    using Answer = std::invoke_result_t<Work, std::stop_token>;
    std::packaged_task<Answer(std::stop_token)> task(std::move(work));
    std::future<Answer> answer = task.get_future();
    std::jthread worker(std::move(task));
    const auto is_done = [&answer] {
        const pybind11::gil_scoped_release others_go_on;
        return answer.wait_for(std::chrono::milliseconds(20)) == std::future_status::ready;
    };
    while (!is_done()) {
        if (PyErr_CheckSignals() == 0) continue;
        const pybind11::error_already_set raised;
        worker.request_stop();
        while (!is_done()) continue;
        throw raised;
    }
    return answer.get();
}

}  // namespace tact
