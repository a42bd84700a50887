// When an exact search has to give up: at a stop, or at a time by the clock.
#pragma once

#include <chrono>
#include <limits>
#include <stop_token>
#include <utility>

#include "model/system/pauses.h"

namespace tact {

struct SearchLimit {
    std::stop_token stop;
    std::chrono::steady_clock::time_point end = std::chrono::steady_clock::time_point::max();

    bool reached() const {
        pause_if_due();  // every search asks often
        if (stop.stop_requested()) return true;
        return is_by_clock() && std::chrono::steady_clock::now() >= end;
    }
    bool is_by_clock() const { return end != std::chrono::steady_clock::time_point::max(); }
    // Below 0 when it is reached; without a limit by the clock infinity.
    double left_s() const {
        if (!is_by_clock()) return std::numeric_limits<double>::infinity();
        return std::chrono::duration<double>(end - std::chrono::steady_clock::now()).count();
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
