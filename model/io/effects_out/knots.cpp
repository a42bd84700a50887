#include "model/io/effects_out/knots.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <optional>

#include "model/io/effects/sketch.h"
#include "model/pattern/curves.h"
#include "model/text/numbers.h"

namespace tact {

namespace {

double whole_ticks_s(double t_s, double tick_s) { return std::round(t_s / tick_s) * tick_s; }

std::vector<double> times_of_both(const AmplitudeCurve& amplitude, const AmplitudeCurve& frequency,
                                  double duration_s) {
    std::vector<double> times{0.0, duration_s};
    for (const AmplitudeCurve* curve : {&amplitude, &frequency}) {
        for (const AmplitudePoint& point : *curve) {
            if (point.time_s <= duration_s) times.push_back(point.time_s);
        }
    }
    std::ranges::sort(times);
    times.erase(std::unique(times.begin(), times.end()), times.end());
    return times;
}

Knot knot_between(const Knot& a, const Knot& b, double t_s) {
    const double length_s = b.time_s - a.time_s;
    const double share = length_s > 0.0 ? (t_s - a.time_s) / length_s : 0.0;
    return {t_s, a.amplitude + share * (b.amplitude - a.amplitude),
            a.frequency + share * (b.frequency - a.frequency)};
}

// What is felt of a point is dear to know: of very many, those are asked that are farthest off.
AmplitudeCurve at_most(AmplitudeCurve curve, std::size_t most) {
    if (curve.size() > most) thin(curve, most, 0.0);
    return curve;
}

struct Off {
    double amplitude = 0.0;
    double frequency = 0.0;
};

Off off_by(const Knot& asked, const Knot& got) {
    return {std::abs(asked.amplitude - got.amplitude), std::abs(asked.frequency - got.frequency)};
}

double weighed(const Off& off, const KnotRules& rules) {
    return std::max(off.amplitude, off.frequency / rules.frequency_unit);
}

// What points there may be: where the curves have theirs, and a gap beside each jump.
std::vector<Knot> candidates_of(const AmplitudeCurve& amplitude, const AmplitudeCurve& frequency,
                                const std::vector<double>& times, double end_s,
                                const KnotRules& rules) {
    std::vector<Knot> all;
    const auto add = [&](double t_s, const Sides& a, const Sides& f, bool behind) {
        const double at_s = std::clamp(whole_ticks_s(t_s, rules.tick_s), 0.0, end_s);
        double hz = behind ? f.behind : f.before;
        if (rules.frequency_step > 0.0) hz = whole_ticks_s(hz, rules.frequency_step);
        all.push_back({at_s, behind ? a.behind : a.before, hz});
    };
    for (const double t_s : times) {
        const Sides a = sides_at(amplitude, t_s);
        const Sides f = sides_at(frequency, t_s);
        const bool jumps = a.before != a.behind || f.before != f.behind;
        add(t_s, a, f, t_s == 0.0);
        const bool ramp = jumps || (rules.from_silence && t_s == 0.0 && a.behind > 0.0);
        if (!ramp) continue;
        for (const double beside_s : {t_s - rules.least_gap_s, t_s + rules.least_gap_s}) {
            if (beside_s <= 0.0 || beside_s >= end_s) continue;
            add(beside_s, sides_at(amplitude, beside_s), sides_at(frequency, beside_s),
                beside_s > t_s);
        }
    }
    std::ranges::stable_sort(all, {}, &Knot::time_s);
    if (rules.from_silence) all.front().amplitude = 0.0;
    return all;
}

// The loudest that is over before a player that begins in silence can be as loud; none where what
// sounds when it can be is half as loud or more.
std::optional<Knot> missed_pulse(const AmplitudeCurve& amplitude, const AmplitudeCurve& frequency,
                                 const std::vector<double>& times, const KnotRules& rules) {
    if (!rules.from_silence) return std::nullopt;
    Knot loudest{rules.least_gap_s, 0.0, 0.0};
    for (const double t_s : times) {
        if (t_s >= rules.least_gap_s) break;
        const Sides a = sides_at(amplitude, t_s);
        const double here = t_s > 0.0 ? std::max(a.before, a.behind) : a.behind;
        if (here <= loudest.amplitude) continue;
        const Sides f = sides_at(frequency, t_s);
        loudest.amplitude = here;
        loudest.frequency = a.behind >= here ? f.behind : f.before;
    }
    const double then =
        times.back() > rules.least_gap_s ? sides_at(amplitude, rules.least_gap_s).behind : 0.0;
    if (!(loudest.amplitude > 0.0) || 2.0 * then >= loudest.amplitude) return std::nullopt;
    if (rules.frequency_step > 0.0)
        loudest.frequency = whole_ticks_s(loudest.frequency, rules.frequency_step);
    return loudest;
}

double felt_db(const Knot& asked, const Knot& got, const KnotRules& rules) {
    return rules.felt ? felt_error_db(rules.felt(asked), rules.felt(got)) : 0.0;
}

// A knot that there may be, and how far off the lines are where it is.
struct Candidate {
    Knot knot;
    bool has_room = false;
    double off = 0.0;
    double felt_db = 0.0;
};

// Measures the candidates between two successive knots.
void measure_between(std::vector<Candidate>& candidates, const Knot& left, const Knot& right,
                     const KnotRules& rules) {
    const double least_s = rules.least_gap_s - 1e-9;
    const auto time_of = [](const Candidate& one) { return one.knot.time_s; };
    auto one = std::ranges::lower_bound(candidates, left.time_s, {}, time_of);
    for (; one != candidates.end() && time_of(*one) < right.time_s; ++one) {
        one->has_room =
            time_of(*one) - left.time_s >= least_s && right.time_s - time_of(*one) >= least_s;
        if (!one->has_room) continue;
        const Knot line = knot_between(left, right, time_of(*one));
        one->off = weighed(off_by(one->knot, line), rules);
        one->felt_db = one->off > rules.tolerance ? felt_db(one->knot, line, rules) : 0.0;
    }
}

// Adds the candidate that is farthest off and has room; false where none is.
bool add_worst(std::vector<Knot>& kept, std::vector<Candidate>& candidates,
               const KnotRules& rules) {
    const Candidate* worst = nullptr;
    for (const Candidate& one : candidates) {
        if (!one.has_room || !(one.off > rules.tolerance)) continue;
        const bool worse = worst == nullptr || one.felt_db > worst->felt_db ||
                           (one.felt_db == worst->felt_db && one.off > worst->off);
        if (worse) worst = &one;
    }
    if (worst == nullptr) return false;
    const Knot knot = worst->knot;
    const auto at =
        kept.insert(std::ranges::upper_bound(kept, knot.time_s, {}, &Knot::time_s), knot);
    measure_between(candidates, *(at - 1), *at, rules);
    measure_between(candidates, *at, *(at + 1), rules);
    return true;
}

// As the first knot behind the beginning, where there is one to be kept.
void keep_pulse(std::vector<Knot>& kept, std::vector<Candidate>& candidates,
                const std::optional<Knot>& pulse, const KnotRules& rules) {
    if (!pulse) return;
    if (kept.back().time_s - pulse->time_s < rules.least_gap_s - 1e-9) {
        // There is no room behind it: what is left of a pattern so short is its end.
        kept.back().amplitude = pulse->amplitude;
        kept.back().frequency = pulse->frequency;
        return;
    }
    kept.insert(kept.begin() + 1, *pulse);
    measure_between(candidates, kept[0], kept[1], rules);
    measure_between(candidates, kept[1], kept[2], rules);
}

// Where a ramp is in the place of a jump; the beginning is one where the player is silent before.
std::size_t count_of_jumps(const AmplitudeCurve& amplitude, const AmplitudeCurve& frequency,
                           const std::vector<double>& times, const KnotRules& rules) {
    std::size_t jumps = 0;
    for (const double t_s : times) {
        const Sides a = sides_at(amplitude, t_s);
        const Sides f = sides_at(frequency, t_s);
        const bool within = t_s > 0.0 && t_s < times.back();
        const bool jump = within && (a.before != a.behind || f.before != f.behind);
        const bool at_once = t_s == 0.0 && rules.from_silence && a.behind > 0.0;
        if (jump || at_once) ++jumps;
    }
    return jumps;
}

}  // namespace

FittedKnots fitted_knots(const AmplitudeCurve& all_amplitude, const AmplitudeCurve& all_frequency,
                         double duration_s, const KnotRules& rules) {
    assert(!all_amplitude.empty() && !all_frequency.empty() && "curves have points");
    const AmplitudeCurve amplitude = at_most(all_amplitude, kMostWeighed);
    const AmplitudeCurve frequency = at_most(all_frequency, kMostWeighed);
    const double end_s =
        std::max({whole_ticks_s(duration_s, rules.tick_s), rules.least_gap_s, rules.tick_s});
    const std::vector<double> times = times_of_both(amplitude, frequency, duration_s);
    const std::vector<Knot> possible = candidates_of(amplitude, frequency, times, end_s, rules);
    FittedKnots fit;
    fit.points = times_of_both(all_amplitude, all_frequency, duration_s).size();
    fit.knots = {possible.front(), possible.back()};
    fit.knots.back().time_s = end_s;
    std::vector<Candidate> candidates;
    for (const Knot& knot : possible) candidates.push_back({knot});
    measure_between(candidates, fit.knots.front(), fit.knots.back(), rules);
    keep_pulse(fit.knots, candidates, missed_pulse(amplitude, frequency, times, rules), rules);
    while (fit.knots.size() < rules.most && add_worst(fit.knots, candidates, rules)) {
    }
    // A jump is one point of the curves and two of those that it may take.
    const bool is_short = std::ranges::any_of(candidates, [&](const Candidate& one) {
        return one.has_room && one.off > rules.tolerance;
    });
    if (is_short && fit.knots.size() >= fit.points) fit.points = possible.size();
    fit.ramps = count_of_jumps(amplitude, frequency, times, rules);
    return fit;
}

void remark_fit(const FittedKnots& fit, const KnotRules& rules, std::vector<std::string>& coarse) {
    const std::string gap = significant_digits(1e3 * rules.least_gap_s, 3) + " ms";
    if (fit.ramps > 0) {
        coarse.push_back(fit.ramps == 1 ? "a jump becomes a ramp of " + gap
                                        : grouped_digits(fit.ramps) + " jumps become ramps of " +
                                              gap + " or more");
    }
    if (fit.knots.size() >= fit.points) return;
    coarse.push_back(grouped_digits(fit.points) + " points thinned to " +
                     grouped_digits(fit.knots.size()) + ", at least " + gap + " apart");
}

}  // namespace tact
