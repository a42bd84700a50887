// When an exact search has to give up: at a stop, or at a time by the clock.
#pragma once

#include <chrono>
#include <stop_token>
#include <utility>

namespace tact {

struct SearchLimit {
    std::stop_token stop;
    std::chrono::steady_clock::time_point end = std::chrono::steady_clock::time_point::max();

    bool reached() const {
        if (stop.stop_requested()) return true;
        return end != std::chrono::steady_clock::time_point::max() &&
               std::chrono::steady_clock::now() >= end;
    }
};

// From now on; infinity: no limit but the stop.
inline SearchLimit limit_of(double seconds, std::stop_token stop) {
    SearchLimit limit{std::move(stop)};
    if (seconds >= 1e9) return limit;
    using Clock = std::chrono::steady_clock;
    limit.end = Clock::now() +
                std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds));
    return limit;
}

}  // namespace tact
