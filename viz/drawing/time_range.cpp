#include "viz/drawing/time_range.h"

#include <algorithm>

namespace tact {

namespace {

// Moved into 0..duration without changing its length.
TimeRange inside(TimeRange range, double duration_s) {
    const double length_s =
        std::clamp(range.length_s(), kShortestRangeS, std::max(duration_s, kShortestRangeS));
    const double last_start_s = std::max(0.0, duration_s - length_s);
    range.start_s = std::clamp(range.start_s, 0.0, last_start_s);
    range.end_s = range.start_s + length_s;
    return range;
}

}  // namespace

TimeRange zoomed(TimeRange range, double factor, double fixed_s, double duration_s) {
    const double length_s = std::clamp(range.length_s() * factor, kShortestRangeS,
                                       std::max(duration_s, kShortestRangeS));
    const double scale = range.length_s() > 0.0 ? length_s / range.length_s() : 1.0;
    range.start_s = fixed_s - (fixed_s - range.start_s) * scale;
    range.end_s = range.start_s + length_s;
    return inside(range, duration_s);
}

TimeRange panned(TimeRange range, double by_s, double duration_s) {
    return inside({range.start_s + by_s, range.end_s + by_s}, duration_s);
}

TimeRange fitted(TimeRange range, double duration_s) {
    if (range.length_s() <= 0.0 || range.end_s > duration_s + 1e-9) return {0.0, duration_s};
    return range;
}

TimeRange unless_whole(TimeRange range, double duration_s) {
    const TimeRange shown = fitted(range, duration_s);
    return shown.length_s() < duration_s - 1e-9 ? shown : TimeRange{};
}

TimeRange followed(TimeRange range, double at_s, double duration_s) {
    if (range.length_s() <= 0.0 || (at_s >= range.start_s && at_s <= range.end_s)) return range;
    return inside({at_s, at_s + range.length_s()}, duration_s);
}

}  // namespace tact
