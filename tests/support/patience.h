// How long a test waits for what must come: far longer than it ever takes, with sanitizers and on a
// busy machine, too. Only what hangs comes to the end of it.
#pragma once

#include <chrono>

namespace tact {

inline std::chrono::steady_clock::time_point end_of_patience() {
    return std::chrono::steady_clock::now() + std::chrono::minutes(5);
}

}  // namespace tact
