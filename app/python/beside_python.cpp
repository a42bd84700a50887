#include "app/python/beside_python.h"

namespace tact {

namespace {

// Shared by this process: an interpreter ends once.
std::atomic<bool> is_ending = false;
std::atomic<std::thread::id> ends_it;
std::atomic<int> takers = 0;      // threads that have looked, and do not have the lock yet
std::atomic<int> left_alone = 0;  // works that nobody waits for

}  // namespace

void end_beside_python() {
    ends_it = std::this_thread::get_id();
    is_ending = true;
    const auto rest = [] {
        const pybind11::gil_scoped_release others_go_on;
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    };
    while (takers > 0) rest();
    // The end of the process takes away what such a work still uses.
    while (left_alone > 0) {
        rest();
        if (PyErr_CheckSignals() != 0) throw pybind11::error_already_set();
    }
}

bool take_lock_back(PyThreadState* own) {
    ++takers;
    if (is_ending && ends_it.load() != std::this_thread::get_id()) {
        --takers;
        return false;
    }
    PyEval_RestoreThread(own);
    --takers;
    return true;
}

void leave_alone(std::jthread worker) {
    ++left_alone;
    std::thread([worker = std::move(worker)]() mutable {
        worker.join();
        --left_alone;
    }).detach();
}

Progress::Progress(pybind11::object tell) : tell_(std::move(tell)) {
    if (tell_.is_none() || PyCallable_Check(tell_.ptr()) != 0) return;
    throw pybind11::type_error(
        "progress: expected a function of (share, text), True or None, got " +
        std::string(pybind11::str(pybind11::repr(tell_))));
}

std::function<void(double)> Progress::for_work(const char* what) const {
    if (tell_.is_none()) return {};
    return [reached = reached_, what](double share) {
        reached->share = share;
        reached->what = what;
    };
}

void Progress::tell_if_new() {
    const double share = reached_->share;
    const char* const what = reached_->what;
    if (what == nullptr || (share == told_share_ && what == told_what_)) return;
    told_share_ = share;
    told_what_ = what;
    tell_(share, what);
}

}  // namespace tact
