#include "model/system/together.h"

#include <system_error>
#include <thread>
#include <vector>

namespace tact {

// Each thread is a new one, so that it weighs what the one that starts it does (give_way()).
void call_together(std::size_t others, const std::function<void()>& work) {
    std::vector<std::jthread> threads;
    try {
        for (std::size_t k = 0; k < others; ++k) threads.emplace_back(work);
    } catch (const std::system_error&) {
        // The system gives no more threads; those started do the work.
    }
    work();
}

}  // namespace tact
