#include "model/io/effects_out/plain_curves.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>

#include "model/common/portable.h"
#include "model/io/effects/sketch.h"
#include "model/io/effects_out/shares.h"
#include "model/pattern/curves.h"
#include "model/text/numbers.h"

namespace tact {

namespace {

constexpr double kFullTurn = 2.0 * std::numbers::pi;
constexpr double kStepS = 0.010;       // where nothing is known of what bends
constexpr double kLeastStepS = 0.002;  // within it a straight line is at most 1 ms off
constexpr double kBendToleranceDb = 0.05;
constexpr double kFastestHz = 25.0;  // of an envelope that is felt as one
constexpr double kSameTimeS = 1e-9;

// How strong the carriers are together, slow beats and all.
struct CarrierSum {
    std::vector<Carrier> carriers;  // that sound
    Sweep sweep;                    // of the first carrier of the pattern
    double first_hz = 1.0;
    double highest_hz = 1.0;  // that the first carrier reaches

    bool beats_slowly(const Carrier& a, const Carrier& b) const {
        const double ratio = std::abs(a.frequency_hz - b.frequency_hz) / first_hz;
        return ratio * highest_hz <= kFastestHz;
    }
};

CarrierSum carrier_sum(const Pattern& pattern) {
    CarrierSum sum;
    for (const Carrier& carrier : pattern.carriers) {
        if (carrier.weight != 0.0) sum.carriers.push_back(carrier);
    }
    if (pattern.carriers.empty()) return sum;
    sum.first_hz = sum.highest_hz = pattern.carriers.front().frequency_hz;
    FrequencyCurve curve = pattern.frequency_curve;
    if (curve.empty()) curve.push_back({0.0, sum.first_hz});
    sum.highest_hz = std::ranges::max(curve, {}, &FrequencyPoint::frequency_hz).frequency_hz;
    sum.sweep = sweep_of(std::move(curve));
    return sum;
}

double strength_at(const CarrierSum& sum, double t_s) {
    const std::vector<Carrier>& all = sum.carriers;
    if (all.empty()) return 0.0;
    if (all.size() == 1) return std::abs(all.front().weight);
    const double turns = turns_at(sum.sweep, t_s);
    double squares = 0.0;
    for (std::size_t i = 0; i < all.size(); ++i) {
        const auto& [a_hz, a_weight, a_rad] = all[i];
        squares += a_weight * a_weight;
        for (std::size_t j = 0; j < i; ++j) {
            if (!sum.beats_slowly(all[i], all[j])) continue;
            const auto& [b_hz, b_weight, b_rad] = all[j];
            const double ratio = (a_hz - b_hz) / sum.first_hz;
            const double phase = kFullTurn * ratio * turns + a_rad - b_rad;
            squares += 2.0 * a_weight * b_weight * portable::cos(phase);
        }
    }
    return std::sqrt(std::max(squares, 0.0));
}

bool has_beat(const CarrierSum& sum) {
    for (const Carrier& a : sum.carriers) {
        for (const Carrier& b : sum.carriers) {
            if (a.frequency_hz != b.frequency_hz && sum.beats_slowly(a, b)) return true;
        }
    }
    return false;
}

bool is_modulated(const Modulation& modulation) {
    const auto& [kind, frequency_hz, depth] = modulation;
    const bool flat = kind == ModulationKind::am && depth == 0.0;
    return frequency_hz > 0.0 && !flat;
}

bool is_slow(const Modulation& modulation) {
    const double maxima = modulation.kind == ModulationKind::product ? 2.0 : 1.0;
    return maxima * modulation.frequency_hz <= kFastestHz;
}

double strength_at(const Modulation& modulation, double t_s) {
    if (!is_modulated(modulation)) return 1.0;
    const auto& [kind, frequency_hz, depth] = modulation;
    const bool product = kind == ModulationKind::product;
    if (!is_slow(modulation)) {
        return product ? std::sqrt(0.5) : std::sqrt(1.0 + 0.5 * depth * depth);
    }
    const double sine = portable::sin(kFullTurn * frequency_hz * t_s);
    return product ? std::abs(sine) : 1.0 + depth * sine;
}

// The note's gain on one side of a time; 0 between notes.
double gate_at(const Pattern& pattern, const std::vector<Note>& all, double t_s, bool behind) {
    const double at_s = behind ? t_s + kSameTimeS : t_s - kSameTimeS;
    const auto next = std::ranges::upper_bound(all, at_s, {}, &Note::onset_s);
    if (next == all.begin()) return 0.0;
    const Note& note = *(next - 1);
    const double end_s = note.onset_s + note.length_s;
    if (at_s >= end_s) return 0.0;
    double gain = 1.0;
    if (pattern.attack_s > 0.0) gain = std::min(gain, (t_s - note.onset_s) / pattern.attack_s);
    if (pattern.release_s > 0.0) gain = std::min(gain, (end_s - t_s) / pattern.release_s);
    return note.velocity * std::clamp(gain, 0.0, 1.0);
}

bool is_flat(const AmplitudeCurve& curve) {
    return std::ranges::all_of(
        curve, [&](const AmplitudePoint& point) { return point.value == curve.front().value; });
}

// Where the amplitude jumps or has a corner, an extremum or a zero, and every 10 ms where it is not
// straight between.
std::vector<double> times_of_envelope(const Pattern& pattern, const std::vector<Note>& all,
                                      bool sampled) {
    std::vector<double> times{0.0, pattern.duration_s};
    for (const AmplitudePoint& point : pattern.amplitude_curve) times.push_back(point.time_s);
    for (const Note& note : all) {
        const double end_s = note.onset_s + note.length_s;
        const double attack_s = pattern.attack_s;
        const double release_s = pattern.release_s;
        times.insert(times.end(), {note.onset_s, end_s});
        if (attack_s > 0.0) times.push_back(note.onset_s + attack_s);
        if (release_s > 0.0) times.push_back(end_s - release_s);
        if (attack_s + release_s > note.length_s) {  // they meet
            times.push_back(note.onset_s + note.length_s * attack_s / (attack_s + release_s));
        }
    }
    for (int k = 1; sampled && k * kStepS < pattern.duration_s; ++k) times.push_back(k * kStepS);
    if (is_modulated(pattern.modulation) && is_slow(pattern.modulation)) {
        const double quarter_s = 0.25 / pattern.modulation.frequency_hz;
        for (int k = 1; k * quarter_s < pattern.duration_s; ++k) times.push_back(k * quarter_s);
    }
    std::erase_if(times, [&](double t_s) { return !(t_s >= 0.0 && t_s <= pattern.duration_s); });
    std::ranges::sort(times);
    const auto same = [](double a, double b) { return b - a < kSameTimeS; };
    times.erase(std::unique(times.begin(), times.end(), same), times.end());
    times.back() = pattern.duration_s;
    return times;
}

// Points between two, where a straight line is felt to be off.
void add_bends(std::vector<double>& times, double from_s, double to_s,
               const std::function<FeltTone(double)>& tone_at) {
    if (to_s - from_s < 2.0 * kLeastStepS) return;
    constexpr double kInside = 1e-6;  // of the stretch: at its ends it may jump
    const double length_s = to_s - from_s;
    const double first_g = tone_at(from_s + kInside * length_s).amplitude_g;
    const double last_g = tone_at(to_s - kInside * length_s).amplitude_g;
    const bool straight = std::ranges::all_of(std::array{0.25, 0.5, 0.75}, [&](double share) {
        const FeltTone tone = tone_at(from_s + share * length_s);
        const FeltTone line{first_g + share * (last_g - first_g), tone.frequency_hz};
        return felt_error_db(tone, line) <= kBendToleranceDb;
    });
    if (straight) return;
    const double middle_s = 0.5 * (from_s + to_s);
    add_bends(times, from_s, middle_s, tone_at);
    times.push_back(middle_s);
    add_bends(times, middle_s, to_s, tone_at);
}

std::vector<double> with_bends(const std::vector<double>& times,
                               const std::function<FeltTone(double)>& tone_at) {
    std::vector<double> all{times.front()};
    for (std::size_t k = 1; k < times.size(); ++k) {
        add_bends(all, times[k - 1], times[k], tone_at);
        all.push_back(times[k]);
    }
    return all;
}

// At most as many points as a pattern may have, those that are felt first.
void thin_envelope(PlainCurves& curves, std::vector<std::string>& coarse) {
    AmplitudeCurve& curve = curves.amplitude;
    if (curve.size() <= limits::kMaxCurvePoints) return;
    const AmplitudeCurve all = curve;
    thin_by(curve, limits::kMaxCurvePoints, 0.0, [&](std::size_t k, double line_g) {
        const double hz = sides_at(curves.frequency, all[k].time_s).behind;
        return felt_error_db({all[k].value, hz}, {line_g, hz});
    });
    coarse.push_back("its envelope of " + grouped_digits(all.size()) + " points is drawn with " +
                     grouped_digits(curve.size()));
}

void remark_modulation(const Pattern& pattern, std::vector<std::string>& remarks) {
    if (!is_modulated(pattern.modulation)) return;
    const std::string hz = significant_digits(pattern.modulation.frequency_hz, 4) + " Hz";
    remarks.push_back(is_slow(pattern.modulation)
                          ? "modulation of " + hz + " is drawn into the amplitude"
                          : "modulation of " + hz +
                                " is too fast for an envelope: written as its mean strength");
}

// The frequency of the strongest carrier over time.
FrequencyCurve strongest_of(const Pattern& pattern, const CarrierSum& sum,
                            std::vector<std::string>& remarks) {
    if (sum.carriers.empty()) return {{0.0, sum.first_hz}};
    const Carrier& strongest = *std::ranges::max_element(
        sum.carriers, {}, [](const Carrier& carrier) { return std::abs(carrier.weight); });
    FrequencyCurve curve = pattern.frequency_curve;
    if (curve.empty()) curve.push_back({0.0, sum.first_hz});
    const double ratio = strongest.frequency_hz / sum.first_hz;
    for (FrequencyPoint& point : curve) {
        point.frequency_hz = ratio == 1.0
                                 ? point.frequency_hz
                                 : (pattern.frequency_curve.empty() ? strongest.frequency_hz
                                                                    : ratio * point.frequency_hz);
    }
    if (sum.carriers.size() > 1) {
        remarks.push_back(std::to_string(sum.carriers.size()) + " carriers merged into " +
                          significant_digits(strongest.frequency_hz, 4) + " Hz");
    } else if (strongest.phase_rad != 0.0 || strongest.weight < 0.0) {
        remarks.push_back("the phase of its carrier is left out");
    }
    return curve;
}

// The curve with another value from one time to another.
template <class Point, class Value>
std::vector<Point> with_stretch(const std::vector<Point>& curve, double from_s, double to_s,
                                double end_s, const Value& value) {
    std::vector<Point> result;
    for (const Point& point : curve) {
        if (point.time_s < from_s) result.push_back(point);
    }
    if (from_s > 0.0) result.push_back({from_s, sides_at(curve, from_s).before});
    result.push_back({from_s, value(sides_at(curve, from_s).behind)});
    for (const Point& point : curve) {
        const bool within = point.time_s > from_s && point.time_s < to_s;
        if (within) result.push_back(point);
        if (!within) continue;
        if constexpr (requires { point.value; }) {
            result.back().value = value(point.value);
        } else {
            result.back().frequency_hz = value(point.frequency_hz);
        }
    }
    result.push_back({to_s, value(sides_at(curve, to_s).before)});
    if (to_s < end_s) result.push_back({to_s, sides_at(curve, to_s).behind});
    for (const Point& point : curve) {
        if (point.time_s > to_s) result.push_back(point);
    }
    return result;
}

// A curve that is changed from its beginning on: what lies behind the changes is not looked at.
template <class Point>
struct Growing {
    const std::vector<Point>& whole;
    std::size_t taken = 0;
    std::vector<Point> changed{};

    void reach(double to_s) {
        while (taken < whole.size() && (changed.empty() || changed.back().time_s <= to_s)) {
            changed.push_back(whole[taken++]);
        }
    }
    template <class Value>
    void stretch(double from_s, double to_s, double end_s, const Value& value) {
        reach(to_s);
        auto first = std::ranges::lower_bound(changed, from_s, {}, &Point::time_s);
        if (first != changed.begin()) --first;
        const std::vector<Point> part(first, changed.end());
        changed.erase(first, changed.end());
        const std::vector<Point> other = with_stretch(part, from_s, to_s, end_s, value);
        changed.insert(changed.end(), other.begin(), other.end());
    }
    std::vector<Point> all() && {
        changed.insert(changed.end(), whole.begin() + static_cast<std::ptrdiff_t>(taken),
                       whole.end());
        return std::move(changed);
    }
};

}  // namespace

PlainCurves as_curves(const Pattern& pattern, WrittenEffect& written) {
    PlainCurves curves;
    curves.duration_s = pattern.duration_s;
    const CarrierSum sum = carrier_sum(pattern);
    const std::vector<Note> all = notes(pattern.rhythm, pattern.duration_s);
    const bool ramps = pattern.attack_s > 0.0 || pattern.release_s > 0.0;
    const bool swings = is_modulated(pattern.modulation) && is_slow(pattern.modulation);
    const bool sampled = has_beat(sum) || (ramps && !is_flat(pattern.amplitude_curve));
    curves.frequency = strongest_of(pattern, sum, written.remarks);
    remark_modulation(pattern, written.remarks);
    AmplitudeCurve factor = pattern.amplitude_curve;
    if (factor.empty()) factor.push_back({0.0, 1.0});
    const auto strength_g = [&](double t_s) {
        return pattern.amplitude_g * strength_at(sum, t_s) * strength_at(pattern.modulation, t_s);
    };
    const auto tone_at = [&](double t_s) {
        const double g = strength_g(t_s) * sides_at(factor, t_s).behind;
        return FeltTone{g * gate_at(pattern, all, t_s, true),
                        sides_at(curves.frequency, t_s).behind};
    };
    std::vector<double> times = times_of_envelope(pattern, all, sampled);
    if (sampled || swings) times = with_bends(times, tone_at);
    for (const double t_s : times) {
        const double level_g = strength_g(t_s);
        const Sides sides = sides_at(factor, t_s);
        const double before = level_g * sides.before * gate_at(pattern, all, t_s, false);
        const double behind = level_g * sides.behind * gate_at(pattern, all, t_s, true);
        if (t_s > 0.0) curves.amplitude.push_back({t_s, before});
        if (t_s < pattern.duration_s && (t_s == 0.0 || behind != before)) {
            curves.amplitude.push_back({t_s, behind});
        }
    }
    thin_envelope(curves, written.coarse);
    curves.transients = pattern.transients;
    std::erase_if(curves.transients, [](const Transient& one) { return !(one.amplitude_g > 0.0); });
    std::ranges::stable_sort(curves.transients, {}, &Transient::time_s);
    return curves;
}

PlainCurves with_pulses(PlainCurves curves, std::vector<std::string>& remarks) {
    if (curves.transients.empty()) return curves;
    Growing<AmplitudePoint> amplitude{curves.amplitude};
    Growing<FrequencyPoint> frequency{curves.frequency};
    for (const Transient& one : curves.transients) {
        const double end_s = std::min(one.time_s + one.duration_s, curves.duration_s);
        if (!(end_s > one.time_s)) continue;
        amplitude.reach(end_s);
        const bool louder = one.amplitude_g > sides_at(amplitude.changed, one.time_s).behind;
        amplitude.stretch(one.time_s, end_s, curves.duration_s,
                          [&](double beneath) { return std::max(beneath, one.amplitude_g); });
        if (!louder) continue;
        frequency.stretch(one.time_s, end_s, curves.duration_s,
                          [&](double) { return one.frequency_hz; });
    }
    curves.amplitude = std::move(amplitude).all();
    curves.frequency = std::move(frequency).all();
    const std::size_t count = curves.transients.size();
    remarks.push_back(count == 1 ? "a transient is written as a pulse of the amplitude"
                                 : grouped_digits(count) +
                                       " transients are written as pulses of the amplitude");
    curves.transients.clear();
    return curves;
}

}  // namespace tact
