// What can be drawn into a pattern: amplitude and frequency over time, and single bursts.
//
// A curve is straight between its points and held before the first and after the last. Two points
// at one time are a jump; at that time the second one holds.
//
// A transient is a sine, or a square wave, under a window of its duration: Hann flanks of a quarter
// each, flat between them, so that neither clicks. Its phase is model/pattern/accents.h's.
//
// Source    ours; the frequency's integral is exact for each straight piece, not a sum over samples
// Valid     curves without fault (model/pattern/drawn_fault.h)
// Left out  curves of the modulation, of single further carriers and of the rhythm.
#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <vector>

#include "model/common/units.h"
#include "model/signal/thinning.h"

namespace tact {

struct AmplitudePoint {
    double time_s = 0.0;
    double value = 1.0;

    bool operator==(const AmplitudePoint&) const = default;
};

struct FrequencyPoint {
    double time_s = 0.0;
    double frequency_hz = 150.0;

    bool operator==(const FrequencyPoint&) const = default;
};

enum class TransientShape { sine, square };

struct Transient {
    double time_s = 0.0;
    double amplitude_g = 1.0;
    double frequency_hz = 150.0;
    double duration_s = 0.02;
    TransientShape shape = TransientShape::sine;

    bool operator==(const Transient&) const = default;
};

using AmplitudeCurve = std::vector<AmplitudePoint>;
using FrequencyCurve = std::vector<FrequencyPoint>;

namespace limits {
inline constexpr Range kCurveValue{0.0, 1.0};
inline constexpr Range kTransientS{0.001, 1.0};
// Large enough that a minute of any rhythm keeps its notes.
inline constexpr std::size_t kMaxCurvePoints = 100'000;  // of each curve
inline constexpr std::size_t kMaxTransients = 10'000;
}  // namespace limits

// 1 for an empty curve.
double value_at(const AmplitudeCurve& curve, double t_s);

// Nothing for an empty curve.
std::optional<double> frequency_at(const FrequencyCurve& curve, double t_s);

// A frequency curve with the turns until each of its points:
// from (t0, f0) to (t1, f1) they grow by f0 u + (f1 - f0) u^2 / (2 (t1 - t0)), u = t - t0.
struct Sweep {
    FrequencyCurve curve;
    std::vector<double> turns;
};

Sweep sweep_of(FrequencyCurve curve);

// Turns since 0 s. Asserts that there are points.
double turns_at(const Sweep& sweep, double t_s);

// The transient so long after its beginning at phase 0; 0 g outside of its duration.
double transient_g(const Transient& transient, double since_s);

// Where the time of point k may go so that the curve keeps its rules: from its predecessor to its
// successor, both included where that makes a jump of two and no more. It stays where it is if
// there is no room.
Range room_of(const AmplitudeCurve& curve, std::size_t k, double duration_s);
Range room_of(const FrequencyCurve& curve, std::size_t k, double duration_s);

// Puts a point on the curve where it is at that time, so that nothing is heard of it yet; of an
// empty frequency curve at `frequency_hz`. Its position, or none where the curve is full or has
// two points there.
std::optional<std::size_t> insert_point(AmplitudeCurve& curve, double t_s);
std::optional<std::size_t> insert_point(FrequencyCurve& curve, double t_s, double frequency_hz);

// Without what lies behind the end: a curve that ran on gets a point there.
void cut_at(AmplitudeCurve& curve, double end_s);
void cut_at(FrequencyCurve& curve, double end_s);

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
