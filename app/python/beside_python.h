// Work of the model while Python continues: its other threads run meanwhile, and Ctrl+C stops it.
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

// Says that the interpreter ends, for its atexit: until this returns, who was about to take the
// lock back has it. Later the interpreter would end such a thread in the middle of our frames.
void end_beside_python();

// Takes the interpreter's lock back for this thread; false, and without it, if the interpreter ends
// and the thread is not the one that ends it.
bool take_lock_back(PyThreadState* own);

// Parks a thread that the interpreter no longer waits for. Its work is stopped, and it sleeps until
// the process is over.
template <class Answer>
void stay_behind(std::jthread& worker, std::future<Answer>& answer) {
    worker.request_stop();
    answer.wait();
    for (;;) std::this_thread::sleep_for(std::chrono::hours(1));
}

// What work(stop_token) returns, or throws. `work` must not touch Python. Where a signal's handler
// raises (KeyboardInterrupt), the work is stopped, waited for, and that is thrown instead.
template <class Work>
auto beside_python(Work work) {
    using Answer = std::invoke_result_t<Work, std::stop_token>;
    std::packaged_task<Answer(std::stop_token)> task(std::move(work));
    std::future<Answer> answer = task.get_future();
    std::jthread worker(std::move(task));
    const auto is_done = [&answer, &worker] {
        PyThreadState* const own = PyEval_SaveThread();  // others continue
        const bool done =
            answer.wait_for(std::chrono::milliseconds(20)) == std::future_status::ready;
        if (!take_lock_back(own)) stay_behind(worker, answer);
        return done;
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
