#include "model/io/effects_out/knots.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "model/io/effects/sketch.h"
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

// The lines at a time; held behind the last one.
Knot knot_at(const std::vector<Knot>& knots, double t_s) {
    const auto next = std::ranges::upper_bound(knots, t_s, {}, &Knot::time_s);
    if (next == knots.begin()) return knots.front();
    if (next == knots.end()) return knots.back();
    return knot_between(*(next - 1), *next, t_s);
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

// Of those between two knots that follow each other.
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

// Where a ramp is in the place of a jump; the beginning is one where the player is silent before.
std::vector<double> times_of_jumps(const AmplitudeCurve& amplitude, const AmplitudeCurve& frequency,
                                   const std::vector<double>& times, const KnotRules& rules) {
    std::vector<double> jumps;
    for (const double t_s : times) {
        const Sides a = sides_at(amplitude, t_s);
        const Sides f = sides_at(frequency, t_s);
        const bool within = t_s > 0.0 && t_s < times.back();
        const bool jump = within && (a.before != a.behind || f.before != f.behind);
        const bool at_once = t_s == 0.0 && rules.from_silence && a.behind > 0.0;
        if (jump || at_once) jumps.push_back(t_s);
    }
    return jumps;
}

void measure(FittedKnots& fit, const AmplitudeCurve& amplitude, const AmplitudeCurve& frequency,
             const std::vector<double>& times, const KnotRules& rules) {
    const std::vector<double> jumps = times_of_jumps(amplitude, frequency, times, rules);
    fit.ramps = jumps.size();
    const auto note = [&](double t_s, bool behind) {
        const Sides a = sides_at(amplitude, t_s);
        const Sides f = sides_at(frequency, t_s);
        const Knot asked{t_s, behind ? a.behind : a.before, behind ? f.behind : f.before};
        const Off off = off_by(asked, knot_at(fit.knots, t_s));
        fit.amplitude_error = std::max(fit.amplitude_error, off.amplitude);
        fit.frequency_error = std::max(fit.frequency_error, off.frequency);
        const double error_db = felt_db(asked, knot_at(fit.knots, t_s), rules);
        fit.felt_error_db = std::max(fit.felt_error_db, error_db);
    };
    for (const double t_s : times) {
        const bool on_ramp = std::ranges::any_of(jumps, [&](double jump_s) {
            return std::abs(t_s - jump_s) < rules.least_gap_s - 0.5 * rules.tick_s;
        });
        if (!on_ramp) note(t_s, t_s == 0.0);
    }
    // Whether each ramp is there, or was thinned away.
    for (const double jump_s : jumps) {
        const double from_s = jump_s - rules.least_gap_s;
        const double to_s = jump_s + rules.least_gap_s;
        if (from_s >= 0.0) note(from_s, true);
        if (to_s <= times.back()) note(to_s, false);
    }
}

}  // namespace

FittedKnots fitted_knots(const AmplitudeCurve& amplitude, const AmplitudeCurve& frequency,
                         double duration_s, const KnotRules& rules) {
    assert(!amplitude.empty() && !frequency.empty() && "curves have points");
    const double end_s =
        std::max({whole_ticks_s(duration_s, rules.tick_s), rules.least_gap_s, rules.tick_s});
    const std::vector<double> times = times_of_both(amplitude, frequency, duration_s);
    const std::vector<Knot> possible = candidates_of(amplitude, frequency, times, end_s, rules);
    FittedKnots fit;
    fit.points = times.size();
    fit.knots = {possible.front(), possible.back()};
    fit.knots.back().time_s = end_s;
    std::vector<Candidate> candidates;
    for (const Knot& knot : possible) candidates.push_back({knot});
    measure_between(candidates, fit.knots.front(), fit.knots.back(), rules);
    while (fit.knots.size() < rules.most && add_worst(fit.knots, candidates, rules)) {
    }
    measure(fit, amplitude, frequency, times, rules);
    return fit;
}

void remark_fit(const FittedKnots& fit, const KnotRules& rules, double duration_s,
                const std::string& frequency_unit, std::vector<std::string>& remarks) {
    constexpr double kRoundingOff = 1e-9;
    const double end_s = fit.knots.back().time_s;
    if (std::abs(end_s - duration_s) > kRoundingOff) {
        remarks.push_back("lasts " + significant_digits(1e3 * end_s, 6) + " ms in place of " +
                          significant_digits(1e3 * duration_s, 6) + " ms");
    }
    const std::string gap = significant_digits(1e3 * rules.least_gap_s, 3) + " ms";
    if (fit.ramps > 0) {
        remarks.push_back(fit.ramps == 1 ? "a jump becomes a ramp of " + gap
                                         : grouped_digits(fit.ramps) + " jumps become ramps of " +
                                               gap + " or more");
    }
    const bool amplitude = fit.amplitude_error > kRoundingOff;
    const bool frequency = fit.frequency_error > kRoundingOff * rules.frequency_unit;
    if (!amplitude && !frequency) return;
    std::string text = grouped_digits(fit.points) +
                       (fit.knots.size() < fit.points ? " points thinned to " : " points become ") +
                       grouped_digits(fit.knots.size()) + ", at least " + gap + " apart";
    std::string numbers;
    if (amplitude) numbers = significant_digits(fit.amplitude_error, 2) + " of full scale";
    if (frequency) {
        numbers += (numbers.empty() ? "" : ", ") + significant_digits(fit.frequency_error, 2) +
                   frequency_unit;
    }
    text += ", at most " + felt_words(fit.felt_error_db, numbers);
    remarks.push_back(text);
}

}  // namespace tact
