#include "model/algebra/drawn_notes.h"

#include <algorithm>
#include <set>

namespace tact {

namespace {

constexpr int kPieces = 16;

// Times that differ by rounding alone are one.
constexpr double kSameTimeS = 1e-9;

void draw_note(AmplitudeCurve& gate, const Pattern& pattern, Note note) {
    const double end_s = note.onset_s + note.length_s;
    const double ramps_s = pattern.attack_s + pattern.release_s;
    if (!gate.empty() && note.onset_s < gate.back().time_s + kSameTimeS) {
        note.onset_s = gate.back().time_s;
        note.length_s = end_s - note.onset_s;
    }
    if (gate.empty() && note.onset_s > 0.0) append_point(gate, 0.0, 0.0);
    if (!gate.empty() && gate.back().time_s < note.onset_s) {
        append_point(gate, gate.back().time_s, 0.0);
        append_point(gate, note.onset_s, 0.0);
    }
    const double full = note.velocity;
    append_point(gate, note.onset_s, pattern.attack_s > 0.0 ? 0.0 : full);
    if (ramps_s > note.length_s) {
        const double share = note.length_s / ramps_s;
        append_point(gate, note.onset_s + share * pattern.attack_s, share * full);
    } else {
        if (pattern.attack_s > 0.0) append_point(gate, note.onset_s + pattern.attack_s, full);
        append_point(gate, std::max(note.onset_s + pattern.attack_s, end_s - pattern.release_s),
                     full);
    }
    append_point(gate, end_s, pattern.release_s > 0.0 ? 0.0 : full);
}

AmplitudeCurve gate_of(const Pattern& pattern) {
    AmplitudeCurve gate;
    for (const Note& note : notes(pattern.rhythm, pattern.duration_s)) {
        draw_note(gate, pattern, note);
    }
    if (gate.empty()) return {{0.0, 0.0}};  // rests alone
    if (gate.back().time_s < pattern.duration_s - kSameTimeS) {
        append_point(gate, gate.back().time_s, 0.0);
    }
    return gate;
}

}  // namespace

void append_point(AmplitudeCurve& curve, double time_s, double value) {
    const std::size_t n = curve.size();
    if (n > 0 && curve[n - 1] == AmplitudePoint{time_s, value}) return;
    if (n > 1 && curve[n - 1].time_s == time_s && curve[n - 2].time_s == time_s) {
        curve[n - 1].value = value;
        if (curve[n - 2].value == value) curve.pop_back();
        return;
    }
    curve.push_back({time_s, value});
}

double value_before(const AmplitudeCurve& curve, double t_s) {
    const auto at = std::ranges::lower_bound(curve, t_s, {}, &AmplitudePoint::time_s);
    return at != curve.end() && at->time_s == t_s ? at->value : value_at(curve, t_s);
}

AmplitudeCurve product(const AmplitudeCurve& a, const AmplitudeCurve& b, double end_s) {
    if (a.empty()) return b;
    if (b.empty()) return a;
    std::set<double> times_s{0.0, end_s};
    for (const AmplitudeCurve* curve : {&a, &b}) {
        for (const AmplitudePoint& point : *curve) times_s.insert(std::min(point.time_s, end_s));
    }
    AmplitudeCurve both;
    for (auto at = times_s.begin(); at != times_s.end(); ++at) {
        append_point(both, *at, value_before(a, *at) * value_before(b, *at));
        if (*at == end_s) break;
        const double a_from = value_at(a, *at);
        const double b_from = value_at(b, *at);
        append_point(both, *at, a_from * b_from);
        const double to_s = *std::next(at);
        const double a_by = value_before(a, to_s) - a_from;
        const double b_by = value_before(b, to_s) - b_from;
        const int pieces = a_by != 0.0 && b_by != 0.0 ? kPieces : 1;
        for (int k = 1; k < pieces; ++k) {
            const double share = static_cast<double>(k) / kPieces;
            append_point(both, *at + share * (to_s - *at),
                         (a_from + share * a_by) * (b_from + share * b_by));
        }
    }
    return both;
}

AmplitudeCurve part_of_curve(const AmplitudeCurve& curve, double from_s, double to_s) {
    if (curve.empty()) return {};
    AmplitudeCurve part{{0.0, value_at(curve, from_s)}};
    for (const AmplitudePoint& point : curve) {
        if (point.time_s <= from_s || point.time_s >= to_s) continue;
        append_point(part, point.time_s - from_s, point.value);
    }
    append_point(part, to_s - from_s, value_before(curve, to_s));
    return part;
}

bool is_steady(const Pattern& pattern) {
    return pattern.rhythm.text.empty() && pattern.attack_s == 0.0 && pattern.release_s == 0.0;
}

Pattern with_drawn_notes(Pattern pattern) {
    if (is_steady(pattern)) return pattern;
    pattern = with_drawn_pitches(std::move(pattern));
    pattern.amplitude_curve =
        product(gate_of(pattern), pattern.amplitude_curve, pattern.duration_s);
    pattern.rhythm.text.clear();
    pattern.rhythm.kinds.clear();
    pattern.attack_s = 0.0;
    pattern.release_s = 0.0;
    return pattern;
}

}  // namespace tact
