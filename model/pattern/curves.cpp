#include "model/pattern/curves.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "model/common/units.h"
#include "model/pattern/accents.h"

namespace tact {

namespace {

// How far from a jump a third point stays.
constexpr double kLeastStepS = 1.0 / kModelRateHz;

double ordinate(const AmplitudePoint& point) { return point.value; }
double ordinate(const FrequencyPoint& point) { return point.frequency_hz; }

// The first point behind the time: of a jump, both points are before it.
template <class Point>
std::size_t next_point(const std::vector<Point>& curve, double t_s) {
    const auto at = std::ranges::upper_bound(curve, t_s, {}, &Point::time_s);
    return static_cast<std::size_t>(at - curve.begin());
}

template <class Point>
double height_at(const std::vector<Point>& curve, double t_s) {
    const std::size_t next = next_point(curve, t_s);
    if (next == 0) return ordinate(curve.front());
    const Point& from = curve[next - 1];
    if (next == curve.size()) return ordinate(from);
    const Point& to = curve[next];
    const double share = (t_s - from.time_s) / (to.time_s - from.time_s);
    return ordinate(from) + (ordinate(to) - ordinate(from)) * share;
}

template <class Point>
Range room(const std::vector<Point>& curve, std::size_t k, double duration_s) {
    assert(k < curve.size());
    Range times{0.0, duration_s};
    if (k > 0) {
        times.low = curve[k - 1].time_s;
        const bool jump = k > 1 && curve[k - 2].time_s == times.low;
        if (jump) times.low += kLeastStepS;
    }
    if (k + 1 < curve.size()) {
        times.high = curve[k + 1].time_s;
        const bool jump = k + 2 < curve.size() && curve[k + 2].time_s == times.high;
        if (jump) times.high -= kLeastStepS;
    }
    if (times.low <= times.high) return times;
    return {curve[k].time_s, curve[k].time_s};
}

template <class Point>
std::optional<std::size_t> insert(std::vector<Point>& curve, double t_s, double height) {
    if (curve.size() >= limits::kMaxCurvePoints) return std::nullopt;
    const std::size_t at = next_point(curve, t_s);
    if (at > 1 && curve[at - 1].time_s == t_s && curve[at - 2].time_s == t_s) return std::nullopt;
    curve.insert(curve.begin() + static_cast<std::ptrdiff_t>(at), Point{t_s, height});
    return at;
}

template <class Point>
void cut(std::vector<Point>& curve, double end_s) {
    if (curve.empty() || curve.back().time_s <= end_s) return;
    const Point end{end_s, height_at(curve, end_s)};
    curve.resize(next_point(curve, end_s));
    if (curve.empty() || curve.back().time_s < end_s) curve.push_back(end);
}

}  // namespace

double value_at(const AmplitudeCurve& curve, double t_s) {
    return curve.empty() ? 1.0 : height_at(curve, t_s);
}

std::optional<double> frequency_at(const FrequencyCurve& curve, double t_s) {
    if (curve.empty()) return std::nullopt;
    return height_at(curve, t_s);
}

Sweep sweep_of(FrequencyCurve curve) {
    Sweep sweep{std::move(curve), {}};
    double turns = 0.0;
    for (std::size_t k = 0; k < sweep.curve.size(); ++k) {
        const FrequencyPoint& to = sweep.curve[k];
        const FrequencyPoint from =
            k == 0 ? FrequencyPoint{0.0, to.frequency_hz} : sweep.curve[k - 1];
        turns += 0.5 * (from.frequency_hz + to.frequency_hz) * (to.time_s - from.time_s);
        sweep.turns.push_back(turns);
    }
    return sweep;
}

double turns_at(const Sweep& sweep, double t_s) {
    assert(!sweep.curve.empty() && "a sweep needs points");
    const std::size_t next = next_point(sweep.curve, t_s);
    if (next == 0) return sweep.curve.front().frequency_hz * t_s;
    const FrequencyPoint& from = sweep.curve[next - 1];
    const double since_s = t_s - from.time_s;
    double mean_hz = from.frequency_hz;  // since the point
    if (next < sweep.curve.size()) {
        // A share, not a slope: however close two points are, it stays finite.
        const FrequencyPoint& to = sweep.curve[next];
        const double share = since_s / (to.time_s - from.time_s);
        mean_hz += 0.5 * share * (to.frequency_hz - from.frequency_hz);
    }
    return sweep.turns[next - 1] + mean_hz * since_s;
}

double transient_g(const Transient& transient, double since_s) {
    return transient_g(transient, since_s, 0.0);
}

Range room_of(const AmplitudeCurve& curve, std::size_t k, double duration_s) {
    return room(curve, k, duration_s);
}

Range room_of(const FrequencyCurve& curve, std::size_t k, double duration_s) {
    return room(curve, k, duration_s);
}

std::optional<std::size_t> insert_point(AmplitudeCurve& curve, double t_s) {
    return insert(curve, t_s, value_at(curve, t_s));
}

std::optional<std::size_t> insert_point(FrequencyCurve& curve, double t_s, double frequency_hz) {
    return insert(curve, t_s, frequency_at(curve, t_s).value_or(frequency_hz));
}

void cut_at(AmplitudeCurve& curve, double end_s) { cut(curve, end_s); }

void cut_at(FrequencyCurve& curve, double end_s) { cut(curve, end_s); }

}  // namespace tact
