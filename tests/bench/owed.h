// What a benchmark owes, printed beside what it measured, and times that can be compared.
//
// Other programs share the machine, so that seconds by the clock say little: compare what ran in
// turns, each at its best, by the time a thread has computed.
#pragma once

#include <benchmark/benchmark.h>
#include <sys/resource.h>

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <cstdio>
#include <ctime>
#include <limits>
#include <vector>

namespace tact::bench {

// The time this thread has computed.
inline double thread_s() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

// The time all threads of this program have computed.
inline double process_s() {
    timespec now{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

// What a person waits, other programs included.
inline double clock_s() {
    const auto now = std::chrono::steady_clock::now().time_since_epoch();
    return std::chrono::duration<double>(now).count();
}

// How often this thread has slept: for a lock, a page of a file or because it wanted to.
inline long slept() {
    rusage used{};
    getrusage(RUSAGE_THREAD, &used);
    return used.ru_nvcsw;
}

// The value that this share of them does not exceed; 0.5: the median.
inline double quantile(std::vector<double> values, double share) {
    if (values.empty()) return 0.0;
    const auto place = static_cast<std::size_t>(share * static_cast<double>(values.size() - 1));
    std::ranges::nth_element(values, values.begin() + static_cast<std::ptrdiff_t>(place));
    return values[place];
}

// The shortest of several turns.
struct Best {
    double shortest_s = std::numeric_limits<double>::infinity();

    template <class Work>
    void turn(const Work& work) {
        const double begin_s = thread_s();
        work();
        shortest_s = std::min(shortest_s, thread_s() - begin_s);
    }
};

inline void owe(benchmark::State& state, double value, const char* relation, double bar,
                const char* unit, bool kept) {
    char text[96];
    std::snprintf(text, sizeof text, "%.3g %s, owed %s %g: %s", value, unit, relation, bar,
                  kept ? "kept" : "MISSED");
    state.SetLabel(text);
}

inline void owe_at_least(benchmark::State& state, double value, double bar, const char* unit) {
    owe(state, value, ">=", bar, unit, value >= bar);
}

inline void owe_at_most(benchmark::State& state, double value, double bar, const char* unit) {
    owe(state, value, "<=", bar, unit, value <= bar);
}

}  // namespace tact::bench
