// What reading may still cost. Whoever reads what others wrote pays while it reads, so that a limit
// is met before the work is done, not behind it.
//
// What stands in a text is paid by its bytes. What a text makes beyond them, as a reference does
// that names a thousand keyframes, is paid in points: so memory and time stay in proportion to the
// bytes, for a small file that refers to itself as for a large one.
//
// Input     one Budget for all that is opened together; readers take it by reference and lower it
// Output    what is wrong, as the end of a sentence, or empty
// Left out  the time that a parser of JSON or XML takes for its text: that is bounded by its bytes.
#pragma once

#include <chrono>
#include <cstddef>
#include <stop_token>
#include <string>

namespace tact {

struct Budget {
    using Clock = std::chrono::steady_clock;

    std::size_t points = 300'000;  // keyframes, samples of curves: made beyond what is written
    std::size_t names = 100'000;   // vibrations that come of all files
    Clock::time_point until = Clock::time_point::max();  // default: no end
    std::stop_token stop;
};

// Takes `count` of what is left; false, and nothing is left, where that is too little.
inline bool pay(std::size_t& left, std::size_t count) {
    const bool is_enough = count <= left;
    left = is_enough ? left - count : 0;
    return is_enough;
}

// Why reading is to end here though nothing is wrong with the file.
inline std::string halted(const Budget& budget) {
    if (budget.stop.stop_requested()) return "reading was cancelled";
    const bool has_end = budget.until != Budget::Clock::time_point::max();
    if (has_end && Budget::Clock::now() > budget.until) return "expected a file that reads faster";
    return {};
}

}  // namespace tact
