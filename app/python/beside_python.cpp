#include "app/python/beside_python.h"

#include <atomic>

namespace tact {

namespace {

// Shared by this process: an interpreter ends once.
std::atomic<bool> is_ending = false;
std::atomic<std::thread::id> ends_it;
std::atomic<int> takers = 0;  // threads that have looked, and do not have the lock yet

}  // namespace

void end_beside_python() {
    ends_it = std::this_thread::get_id();
    is_ending = true;
    const pybind11::gil_scoped_release others_go_on;
    while (takers > 0) std::this_thread::sleep_for(std::chrono::milliseconds(1));
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

}  // namespace tact
