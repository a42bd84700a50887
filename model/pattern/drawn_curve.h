// What curves of either kind have in common: heights over times, made of few points.
#pragma once

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include "model/pattern/curves.h"
#include "model/signal/thinning.h"

namespace tact {

inline double height_of(const AmplitudePoint& point) { return point.value; }
inline double height_of(const FrequencyPoint& point) { return point.frequency_hz; }

// The largest amplitude of the curve; 0 of none.
inline double peak_value(const AmplitudeCurve& curve) {
    double peak = 0.0;
    for (const AmplitudePoint& point : curve) peak = std::max(peak, point.value);
    return peak;
}

// Hz in the place of amplitudes, for what is made of either.
inline AmplitudeCurve heights_of(const FrequencyCurve& curve) {
    AmplitudeCurve heights;
    for (const FrequencyPoint& point : curve) heights.push_back({point.time_s, point.frequency_hz});
    return heights;
}

// Keeps at most `most_points` (model/signal/thinning.h), and gives the error of those dropped, in
// the curve's unit.
template <class Point>
Thinning thin_by(std::vector<Point>& curve, std::size_t most_points, double tolerance,
                 const ThinningWeight& weight) {
    std::vector<double> times_s;
    std::vector<double> heights;
    for (const Point& point : curve) {
        times_s.push_back(point.time_s);
        heights.push_back(height_of(point));
    }
    Thinning line = thinned(times_s, heights, most_points, tolerance, weight);
    std::vector<Point> kept;
    for (const std::size_t k : line.kept) kept.push_back(curve[k]);
    curve = std::move(kept);
    return line;
}

template <class Point>
double thin(std::vector<Point>& curve, std::size_t most_points, double tolerance) {
    return thin_by(curve, most_points, tolerance, {}).largest_error;
}

}  // namespace tact
