// Waiting for what must come, not for time.
#pragma once

#include <chrono>
#include <thread>

#include "tests/support/patience.h"

namespace tact {

// Whether it holds before the end of patience.
template <class Condition>
bool comes_true(const Condition& condition) {
    const auto until = end_of_patience();
    while (!condition()) {
        if (std::chrono::steady_clock::now() > until) return false;
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
    return true;
}

}  // namespace tact
