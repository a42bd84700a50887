#include <algorithm>
#include <cmath>

#include "model/morph/morph_parts.h"
#include "model/pattern/curves.h"

namespace tact {

namespace {

double middle_s(double from_s, double to_s, double share) {
    return between(from_s, to_s, share, BlendBy::difference);
}

// A ramp over a slope is a parabola, which a line of points follows by as many as it takes.
void add_bends_of_ramps(const Pattern& pattern, const Note& note, std::vector<double>& times_s) {
    constexpr double kOff = 1e-4;  // of the full strength
    if (pattern.amplitude_curve.empty()) return;
    const double end_s = note.onset_s + note.length_s;
    std::vector<double> bends{note.onset_s, end_s};
    for (const double t_s : times_s) {
        if (t_s > note.onset_s && t_s < end_s) bends.push_back(t_s);
    }
    std::ranges::sort(bends);
    for (std::size_t k = 0; k + 1 < bends.size(); ++k) {
        const double length_s = bends[k + 1] - bends[k];
        const double middle_s = 0.5 * (bends[k] + bends[k + 1]);
        // The rise is taken inside the piece: at its ends the curve may jump.
        const double rises = amplitude_factor(pattern, middle_s + 0.25 * length_s) -
                             amplitude_factor(pattern, middle_s - 0.25 * length_s);
        const double ramp_s = middle_s < note.onset_s + pattern.attack_s ? pattern.attack_s
                              : middle_s > end_s - pattern.release_s     ? pattern.release_s
                                                                         : 0.0;
        if (!(ramp_s > 0.0) || rises == 0.0) continue;
        const double off = std::abs(2.0 * rises) * length_s / ramp_s / 4.0;
        const double parts = std::ceil(std::sqrt(off / kOff));
        for (double part = 1.0; part < parts; part += 1.0) {
            times_s.push_back(bends[k] + length_s * part / parts);
        }
    }
}

// Strength of a note's part over its time, 0 to 1: ramps, amplitude curve, or nothing.
BentLine line_of(const Pattern& pattern, const NoteSide& side) {
    const double begin_s = side.begin_s;
    const double extent_s = side.end_s - side.begin_s;
    if (!side.whole || !(extent_s > 0.0)) return {{}, [](double) { return 0.0; }};
    const Note note = *side.whole;
    const double end_s = note.onset_s + note.length_s;
    const double ramps_s = pattern.attack_s + pattern.release_s;
    std::vector<double> times_s{note.onset_s + pattern.attack_s, end_s - pattern.release_s};
    // Ramps that meet before either is through.
    if (ramps_s > note.length_s) {
        times_s = {note.onset_s + note.length_s * pattern.attack_s / ramps_s};
    }
    // Many notes with many points: each note takes its own.
    const auto first = std::ranges::lower_bound(pattern.amplitude_curve, side.begin_s, {},
                                                &AmplitudePoint::time_s);
    for (auto point = first; point != pattern.amplitude_curve.end(); ++point) {
        if (point->time_s > side.end_s) break;
        times_s.push_back(point->time_s);
    }
    add_bends_of_ramps(pattern, note, times_s);
    BentLine line;
    for (const double t_s : times_s) line.bends.push_back((t_s - begin_s) / extent_s);
    line.at = [&pattern, note, begin_s, extent_s, end_s](double place) {
        const double t_s = begin_s + place * extent_s;
        double gain = 1.0;
        if (pattern.attack_s > 0.0) gain = std::min(gain, (t_s - note.onset_s) / pattern.attack_s);
        if (pattern.release_s > 0.0) gain = std::min(gain, (end_s - t_s) / pattern.release_s);
        return note.velocity * std::max(0.0, gain) * amplitude_factor(pattern, t_s);
    };
    return line;
}

// The first and the last of the points at one time are the jump; if both are alike, one is enough.
void add_point(AmplitudeCurve& curve, AmplitudePoint point) {
    const std::size_t n = curve.size();
    if (n > 0) point.time_s = std::max(point.time_s, curve.back().time_s);
    if (n > 1 && curve[n - 2].time_s == point.time_s) curve.pop_back();
    if (!curve.empty() && curve.back() == point) return;
    curve.push_back(point);
}

void add_note(AmplitudeCurve& curve, const Pattern& from, const Pattern& to, const WarpedNote& note,
              double share) {
    const double begin_s = middle_s(note.from.begin_s, note.to.begin_s, share);
    const double end_s = middle_s(note.from.end_s, note.to.end_s, share);
    if (!(end_s > begin_s)) return;
    add_point(curve, {begin_s, 0.0});
    for (const auto& [place, height] :
         blended(line_of(from, note.from), line_of(to, note.to), share, BlendBy::difference)) {
        add_point(curve, {begin_s + place * (end_s - begin_s), std::clamp(height, 0.0, 1.0)});
    }
    add_point(curve, {end_s, 0.0});
}

template <class Point>
std::vector<double> bends_of(const std::vector<Point>& curve, double duration_s) {
    std::vector<double> bends;
    for (const Point& point : curve) bends.push_back(point.time_s / duration_s);
    return bends;
}

template <class Point>
void keep_few(std::vector<Point>& curve) {
    if (curve.size() > limits::kMaxCurvePoints) thin(curve, limits::kMaxCurvePoints, 0.0);
}

}  // namespace

AmplitudeCurve notes_between(const Pattern& from, const Pattern& to,
                             const std::vector<WarpedNote>& notes, double share) {
    AmplitudeCurve curve;
    for (const WarpedNote& note : notes) add_note(curve, from, to, note, share);
    if (curve.empty()) curve.push_back({0.0, 0.0});
    keep_few(curve);
    return curve;
}

AmplitudeCurve amplitude_between(const Pattern& from, const Pattern& to, double share) {
    if (from.amplitude_curve.empty() && to.amplitude_curve.empty()) return {};
    const auto line_over = [](const Pattern& pattern) {
        return BentLine{bends_of(pattern.amplitude_curve, pattern.duration_s),
                        [&pattern](double place) {
                            return amplitude_factor(pattern, place * pattern.duration_s);
                        }};
    };
    const double duration_s = middle_s(from.duration_s, to.duration_s, share);
    AmplitudeCurve curve;
    for (const auto& [place, height] :
         blended(line_over(from), line_over(to), share, BlendBy::difference)) {
        curve.push_back({place * duration_s, height});
    }
    keep_few(curve);
    return curve;
}

FrequencyCurve frequency_between(const Pattern& from, const Pattern& to, double share) {
    if (from.frequency_curve.empty() && to.frequency_curve.empty()) return {};
    const auto line_over = [](const Pattern& pattern) {
        return BentLine{bends_of(pattern.frequency_curve, pattern.duration_s),
                        [&pattern](double place) {
                            return first_carrier_hz(pattern, place * pattern.duration_s);
                        }};
    };
    const double duration_s = middle_s(from.duration_s, to.duration_s, share);
    FrequencyCurve curve;
    for (const auto& [place, hz] : blended(line_over(from), line_over(to), share, BlendBy::ratio)) {
        curve.push_back({place * duration_s, hz});
    }
    keep_few(curve);
    return curve;
}

}  // namespace tact
