#include "devices/phone/on_off_times.h"

#include <algorithm>
#include <limits>
#include <numeric>

namespace tact {

namespace {

// Puts a time at the end: equal neighbours become one, and a first silence gets its 0.
void append_time(std::vector<int>& ms, bool is_on, std::int64_t time_ms) {
    if (time_ms <= 0) return;
    if (ms.empty() && !is_on) ms.push_back(0);
    const bool ends_on = ms.size() % 2 == 1;
    if (ms.empty() || ends_on != is_on) ms.push_back(0);
    const std::int64_t most = std::numeric_limits<int>::max();
    ms.back() = static_cast<int>(std::min(most, ms.back() + time_ms));
}

// The times between two moments.
void append_stretch(std::vector<int>& to, std::span<const int> ms, std::int64_t from_ms,
                    std::int64_t until_ms) {
    std::int64_t begin_ms = 0;
    for (std::size_t k = 0; k < ms.size(); ++k) {
        const std::int64_t end_ms = begin_ms + ms[k];
        append_time(to, k % 2 == 0, std::min(end_ms, until_ms) - std::max(begin_ms, from_ms));
        begin_ms = end_ms;
    }
}

}  // namespace

bool is_ever_on(std::span<const int> ms) {
    for (std::size_t k = 0; k < ms.size(); k += 2) {
        if (ms[k] > 0) return true;
    }
    return false;
}

std::int64_t length_ms(std::span<const int> ms) {
    return std::accumulate(ms.begin(), ms.end(), std::int64_t{0});
}

std::vector<int> on_off_from(std::span<const int> ms, std::int64_t from_ms, bool loop) {
    const std::int64_t whole_ms = length_ms(ms);
    if (whole_ms == 0) return {};
    const std::int64_t from = loop ? from_ms % whole_ms : from_ms;
    std::vector<int> left;
    append_stretch(left, ms, from, whole_ms);
    if (loop) append_stretch(left, ms, 0, from);
    return left;
}

std::vector<int> padded_on_off(std::vector<int> ms, std::int64_t to_ms) {
    if (!is_ever_on(ms)) return {};
    append_time(ms, false, to_ms - length_ms(ms));
    return ms;
}

}  // namespace tact
