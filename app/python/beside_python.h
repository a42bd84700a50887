// Work of the model while Python continues: its other threads run meanwhile, Ctrl+C stops it, and a
// function of Python is told how far it is.
//
// Python tells of signals only who asks, and only its main thread: the thread that called asks
// every few hundredths of a second, on behalf of the one that works.
#pragma once

#include <pybind11/pybind11.h>

#include <atomic>
#include <chrono>
#include <functional>
#include <future>
#include <memory>
#include <stop_token>
#include <thread>
#include <type_traits>
#include <utility>

namespace tact {

// Says that the interpreter ends, for its atexit: until this returns, who was about to take the
// lock back has it. Later the interpreter would end such a thread in the middle of our frames.
// Work that was left alone comes to its end first, unless a signal's handler raises.
void end_beside_python();

// Takes the interpreter's lock back for this thread; false, and without it, if the interpreter ends
// and the thread is not the one that ends it.
bool take_lock_back(PyThreadState* own);

// How far the work is, for a function of Python: tell(share from 0 to 1, what is done). The work
// calls for_work(), from any thread; who called asks tell_if_new(), with the lock.
class Progress {
  public:
    // None: nobody is told.
    explicit Progress(pybind11::object tell);
    std::function<void(double)> for_work(const char* what) const;
    void tell_if_new();

  private:
    struct Reached {
        std::atomic<double> share = 0.0;
        std::atomic<const char*> what = nullptr;
    };
    pybind11::object tell_;
    std::shared_ptr<Reached> reached_ = std::make_shared<Reached>();
    double told_share_ = -1.0;
    const char* told_what_ = nullptr;
};

// Joins the thread in another one, and counts it until then.
void leave_alone(std::jthread worker);

// Parks a thread that the interpreter no longer waits for. Its work is stopped, and it sleeps until
// the process is over.
template <class Answer>
void stay_behind(std::jthread& worker, std::future<Answer>& answer) {
    worker.request_stop();
    answer.wait();
    for (;;) std::this_thread::sleep_for(std::chrono::hours(1));
}

// Work on a thread of its own.
template <class Answer>
struct Running {
    std::future<Answer> answer;
    std::jthread worker;

    // Whether it comes to its end within some hundredths of a second, in which Python continues.
    bool ends_soon() {
        PyThreadState* const own = PyEval_SaveThread();
        const bool done =
            answer.wait_for(std::chrono::milliseconds(20)) == std::future_status::ready;
        if (!take_lock_back(own)) stay_behind(worker, answer);
        return done;
    }

    // Until its end, or throws what a signal's handler or `progress` raised.
    void wait(Progress* progress) {
        while (!ends_soon()) {
            if (PyErr_CheckSignals() != 0) throw pybind11::error_already_set();
            if (progress != nullptr) progress->tell_if_new();
        }
        if (progress != nullptr) progress->tell_if_new();
    }
};

template <class Work>
auto begun(Work work) {
    using Answer = std::invoke_result_t<Work, std::stop_token>;
    std::packaged_task<Answer(std::stop_token)> task(std::move(work));
    std::future<Answer> answer = task.get_future();
    return Running<Answer>{std::move(answer), std::jthread(std::move(task))};
}

// What work(stop_token) returns, or throws. `work` must not touch Python. Where a signal's handler
// raises (KeyboardInterrupt), or the function that is told of progress, the work is stopped, waited
// for, and that is thrown instead.
template <class Work>
auto beside_python(Work work, Progress* progress = nullptr) {
    auto running = begun(std::move(work));
    try {
        running.wait(progress);
    } catch (...) {
        running.worker.request_stop();
        while (!running.ends_soon()) continue;
        throw;
    }
    return running.answer.get();
}

// The same of work that may take seconds to heed a stop, and so must own all that it uses: it is
// waited for a moment, then left alone, and what it finds is dropped.
template <class Work>
auto beside_python_or_alone(Work work, Progress* progress = nullptr) {
    auto running = begun(std::move(work));
    try {
        running.wait(progress);
    } catch (...) {
        running.worker.request_stop();
        constexpr int kPatience = 10;
        for (int k = 0; k < kPatience; ++k) {
            if (running.ends_soon()) throw;
        }
        leave_alone(std::move(running.worker));
        throw;
    }
    return running.answer.get();
}

}  // namespace tact
