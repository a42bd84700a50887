#include "model/io/effects_out/plain_curves.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "model/common/portable.h"
#include "model/io/effects/sketch.h"
#include "model/io/effects_out/felt_error.h"
#include "model/pattern/drawn_curve.h"
#include "model/text/numbers.h"

namespace tact {

namespace {

constexpr double kFullTurn = 2.0 * std::numbers::pi;
constexpr double kStepS = 0.010;
constexpr double kFastestHz = 25.0;       // of an envelope that points every 10 ms can follow
constexpr double kBendTolerance = 0.005;  // of the largest amplitude
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
        squares += all[i].weight * all[i].weight;
        for (std::size_t j = 0; j < i; ++j) {
            if (!sum.beats_slowly(all[i], all[j])) continue;
            const double ratio = (all[i].frequency_hz - all[j].frequency_hz) / sum.first_hz;
            const double phase = kFullTurn * ratio * turns + all[i].phase_rad - all[j].phase_rad;
            squares += 2.0 * all[i].weight * all[j].weight * portable::cos(phase);
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
    const bool flat = modulation.kind == ModulationKind::am && modulation.depth == 0.0;
    return modulation.frequency_hz > 0.0 && !flat;
}

bool is_slow(const Modulation& modulation) {
    const double maxima = modulation.kind == ModulationKind::product ? 2.0 : 1.0;
    return maxima * modulation.frequency_hz <= kFastestHz;
}

double strength_at(const Modulation& modulation, double t_s) {
    if (!is_modulated(modulation)) return 1.0;
    const bool product = modulation.kind == ModulationKind::product;
    if (!is_slow(modulation)) {
        return product ? std::sqrt(0.5)
                       : std::sqrt(1.0 + 0.5 * modulation.depth * modulation.depth);
    }
    const double sine = portable::sin(kFullTurn * modulation.frequency_hz * t_s);
    return product ? std::abs(sine) : 1.0 + modulation.depth * sine;
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
    return std::clamp(gain, 0.0, 1.0);
}

bool is_flat(const AmplitudeCurve& curve) {
    return std::ranges::all_of(
        curve, [&](const AmplitudePoint& point) { return point.value == curve.front().value; });
}

// Where the amplitude bends or jumps, and every 10 ms where it is not straight between.
std::vector<double> times_of_envelope(const Pattern& pattern, const std::vector<Note>& all,
                                      bool bent) {
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
    for (int k = 1; bent && k * kStepS < pattern.duration_s; ++k) times.push_back(k * kStepS);
    const bool touches_0 = pattern.modulation.kind == ModulationKind::product;
    if (touches_0 && is_modulated(pattern.modulation) && is_slow(pattern.modulation)) {
        const double half_s = 0.5 / pattern.modulation.frequency_hz;
        for (int k = 1; k * half_s < pattern.duration_s; ++k) times.push_back(k * half_s);
    }
    std::erase_if(times, [&](double t_s) { return !(t_s >= 0.0 && t_s <= pattern.duration_s); });
    std::ranges::sort(times);
    const auto same = [](double a, double b) { return b - a < kSameTimeS; };
    times.erase(std::unique(times.begin(), times.end(), same), times.end());
    times.back() = pattern.duration_s;
    return times;
}

std::string points_text(std::size_t points) {
    return grouped_digits(points) + (points == 1 ? " point" : " points");
}

// As few points as stay within the tolerance, and at most those of a pattern: then those that are
// felt first.
void thin_envelope(PlainCurves& curves, bool bent, std::vector<std::string>& remarks) {
    AmplitudeCurve& curve = curves.amplitude;
    if (!bent && curve.size() <= limits::kMaxCurvePoints) return;
    const double peak = peak_value(curve);
    const double tolerance = bent ? kBendTolerance * peak : 0.0;
    const AmplitudeCurve all = curve;
    const double error = thin(curve, all.size(), tolerance);
    if (!(error > 0.0) && curve.size() <= limits::kMaxCurvePoints) return;
    const auto percent = [&](double g) {
        return significant_digits(100.0 * g / peak, 2) + " % of its largest";
    };
    std::string off = percent(error) + " off";
    if (curve.size() > limits::kMaxCurvePoints) {
        curve = all;
        const Thinning line =
            thin_by(curve, limits::kMaxCurvePoints, 0.0, [&](std::size_t k, double line_g) {
                const double hz = sides_at(curves.frequency, all[k].time_s).behind;
                return felt_error_db({all[k].value, hz}, {line_g, hz});
            });
        off = felt_words(line.largest_weight, percent(line.largest_error));
    }
    remarks.push_back("its envelope is drawn with " + points_text(curve.size()) + ", at most " +
                      off);
}

void remark_modulation(const Pattern& pattern, std::vector<std::string>& remarks) {
    if (!is_modulated(pattern.modulation)) return;
    const std::string hz = significant_digits(pattern.modulation.frequency_hz, 4) + " Hz";
    remarks.push_back(is_slow(pattern.modulation)
                          ? "modulation of " + hz + " is drawn into the amplitude"
                          : "modulation of " + hz +
                                " is too fast for points of 10 ms: written as its mean strength");
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

}  // namespace

PlainCurves as_curves(const Pattern& pattern, std::vector<std::string>& remarks) {
    PlainCurves curves;
    curves.duration_s = pattern.duration_s;
    const CarrierSum sum = carrier_sum(pattern);
    const std::vector<Note> all = notes(pattern.rhythm, pattern.duration_s);
    const bool ramps = pattern.attack_s > 0.0 || pattern.release_s > 0.0;
    const bool swings = is_modulated(pattern.modulation) && is_slow(pattern.modulation);
    const bool bent = swings || has_beat(sum) || (ramps && !is_flat(pattern.amplitude_curve));
    curves.frequency = strongest_of(pattern, sum, remarks);
    remark_modulation(pattern, remarks);
    AmplitudeCurve factor = pattern.amplitude_curve;
    if (factor.empty()) factor.push_back({0.0, 1.0});
    for (const double t_s : times_of_envelope(pattern, all, bent)) {
        const double level_g =
            pattern.amplitude_g * strength_at(sum, t_s) * strength_at(pattern.modulation, t_s);
        const Sides sides = sides_at(factor, t_s);
        const double before = level_g * sides.before * gate_at(pattern, all, t_s, false);
        const double behind = level_g * sides.behind * gate_at(pattern, all, t_s, true);
        if (t_s > 0.0) curves.amplitude.push_back({t_s, before});
        if (t_s < pattern.duration_s && (t_s == 0.0 || behind != before)) {
            curves.amplitude.push_back({t_s, behind});
        }
    }
    thin_envelope(curves, bent, remarks);
    curves.transients = pattern.transients;
    std::erase_if(curves.transients, [](const Transient& one) { return !(one.amplitude_g > 0.0); });
    std::ranges::stable_sort(curves.transients, {}, &Transient::time_s);
    return curves;
}

PlainCurves with_pulses(PlainCurves curves, std::vector<std::string>& remarks) {
    if (curves.transients.empty()) return curves;
    for (const Transient& one : curves.transients) {
        const double end_s = std::min(one.time_s + one.duration_s, curves.duration_s);
        if (!(end_s > one.time_s)) continue;
        const bool louder = one.amplitude_g > sides_at(curves.amplitude, one.time_s).behind;
        curves.amplitude =
            with_stretch(curves.amplitude, one.time_s, end_s, curves.duration_s,
                         [&](double beneath) { return std::max(beneath, one.amplitude_g); });
        if (!louder) continue;
        curves.frequency = with_stretch(curves.frequency, one.time_s, end_s, curves.duration_s,
                                        [&](double) { return one.frequency_hz; });
    }
    const std::size_t count = curves.transients.size();
    remarks.push_back(count == 1 ? "a transient is written as a pulse of the amplitude"
                                 : grouped_digits(count) +
                                       " transients are written as pulses of the amplitude");
    curves.transients.clear();
    return curves;
}

}  // namespace tact
