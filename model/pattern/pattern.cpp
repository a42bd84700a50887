#include "model/pattern/pattern.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "model/common/portable.h"
#include "model/pattern/accents.h"

namespace tact {

namespace {

constexpr double kTurn = 2.0 * std::numbers::pi;

double clamp_to(const Range& range, double value) {
    return std::isfinite(value) ? std::clamp(value, range.low, range.high) : range.low;
}

double modulation_at(const Modulation& modulation, double t_s) {
    if (modulation.frequency_hz == 0.0) return 1.0;
    const double sine = portable::sin(kTurn * modulation.frequency_hz * t_s);
    return modulation.kind == ModulationKind::product ? sine : 1.0 + modulation.depth * sine;
}

double carriers_at(const std::vector<Carrier>& carriers, double t_s) {
    double sum = 0.0;
    for (const Carrier& carrier : carriers) {
        sum +=
            carrier.weight * portable::sin(kTurn * carrier.frequency_hz * t_s + carrier.phase_rad);
    }
    return sum;
}

double swept_carriers_at(const std::vector<Carrier>& carriers, const Sweep& sweep, double t_s,
                         double highest_hz) {
    const double turns = turns_at(sweep, t_s);
    const double first_hz = *frequency_at(sweep.curve, t_s);
    double sum = 0.0;
    for (const Carrier& carrier : carriers) {
        const double ratio = carrier.frequency_hz / carriers.front().frequency_hz;
        if (ratio * first_hz > highest_hz) continue;
        sum += carrier.weight * portable::sin(kTurn * (ratio * turns) + carrier.phase_rad);
    }
    return sum;
}

// Gain of a note at a time after its onset and before its end.
double ramp_gain(const Pattern& pattern, double since_onset_s, double until_end_s) {
    double gain = 1.0;
    if (pattern.attack_s > 0.0) gain = std::min(gain, since_onset_s / pattern.attack_s);
    if (pattern.release_s > 0.0) gain = std::min(gain, until_end_s / pattern.release_s);
    return gain;
}

// Gate of every sample: linear ramps inside each note, 0 between notes.
std::vector<double> rhythm_gate(const Pattern& pattern, double rate_hz, std::size_t samples) {
    std::vector<double> gate(samples, 0.0);
    for (const Note& note : notes(pattern.rhythm, pattern.duration_s)) {
        const std::size_t begin = sample_count(note.onset_s, rate_hz);
        const std::size_t end =
            std::min(sample_count(note.onset_s + note.length_s, rate_hz), samples);
        for (std::size_t n = begin; n < end; ++n) {
            const double since_onset_s = static_cast<double>(n - begin) / rate_hz;
            const double until_end_s = static_cast<double>(end - n) / rate_hz;
            gate[n] = note.velocity * ramp_gain(pattern, since_onset_s, until_end_s);
        }
    }
    return gate;
}

// Times in order, at most two of them equal.
template <class Point>
void keep_rules(std::vector<Point>& curve) {
    double latest_s = 0.0;
    for (Point& point : curve) {
        latest_s = std::max(latest_s, clamp_to({0.0, limits::kDurationS.high}, point.time_s));
        point.time_s = latest_s;
    }
    // If there are more than two, the first and the last are the jump.
    std::vector<Point> kept;
    for (const Point& point : curve) {
        const std::size_t n = kept.size();
        const bool third = n > 1 && kept[n - 2].time_s == point.time_s;
        if (third) kept.pop_back();
        kept.push_back(point);
    }
    kept.resize(std::min(kept.size(), limits::kMaxCurvePoints));
    curve = std::move(kept);
}

void clamp_drawn(Pattern& pattern) {
    for (AmplitudePoint& point : pattern.amplitude_curve) {
        point.value = clamp_to(limits::kCurveValue, point.value);
    }
    for (FrequencyPoint& point : pattern.frequency_curve) {
        point.frequency_hz = clamp_to(limits::kCarrierHz, point.frequency_hz);
    }
    keep_rules(pattern.amplitude_curve);
    keep_rules(pattern.frequency_curve);
    std::vector<Transient>& transients = pattern.transients;
    transients.resize(std::min(transients.size(), limits::kMaxTransients));
    for (Transient& transient : transients) {
        transient.time_s = clamp_to({0.0, limits::kDurationS.high}, transient.time_s);
        transient.amplitude_g = clamp_to(limits::kAmplitudeG, transient.amplitude_g);
        transient.frequency_hz = clamp_to(limits::kCarrierHz, transient.frequency_hz);
        transient.duration_s = clamp_to(limits::kTransientS, transient.duration_s);
    }
}

// Points of a curve over time, at most two at one time: of three the first and the last stay.
void append_frequency(FrequencyCurve& curve, double time_s, double hz) {
    const FrequencyPoint point{time_s, clamp_to(limits::kCarrierHz, hz)};
    const std::size_t n = curve.size();
    if (n > 1 && curve[n - 2].time_s == time_s) {
        curve.back() = point;
    } else if (n == 0 || curve.back() != point) {
        curve.push_back(point);
    }
}

// A pitch from a time on.
struct PitchChange {
    double time_s;
    double pitch;
};

std::vector<PitchChange> pitch_changes(const Pattern& pattern) {
    std::vector<PitchChange> changes;
    for (const Note& note : notes(pattern.rhythm, pattern.duration_s)) {
        if (changes.empty()) {
            changes.push_back({0.0, note.pitch});
        } else if (note.pitch != changes.back().pitch) {
            changes.push_back({note.onset_s, note.pitch});
        }
    }
    return changes;
}

}  // namespace

FrequencyCurve sounding_frequency(const Pattern& pattern) {
    const FrequencyCurve& own = pattern.frequency_curve;
    if (!has_pitches(pattern.rhythm) || pattern.carriers.empty()) return own;
    const double first_hz = pattern.carriers.front().frequency_hz;
    const auto behind_hz = [&](double t_s) { return frequency_at(own, t_s).value_or(first_hz); };
    FrequencyCurve curve;
    const std::vector<PitchChange> changes = pitch_changes(pattern);
    for (std::size_t k = 0; k < changes.size(); ++k) {
        const auto [from_s, pitch] = changes[k];
        const bool is_last = k + 1 == changes.size();
        const double to_s = is_last ? pattern.duration_s : changes[k + 1].time_s;
        append_frequency(curve, from_s, pitch * behind_hz(from_s));
        auto point = std::ranges::upper_bound(own, from_s, {}, &FrequencyPoint::time_s);
        for (; point != own.end() && point->time_s < to_s; ++point) {
            append_frequency(curve, point->time_s, pitch * point->frequency_hz);
        }
        // Where a jump is, its first point.
        const bool has_point = point != own.end() && point->time_s == to_s;
        append_frequency(curve, to_s, pitch * (has_point ? point->frequency_hz : behind_hz(to_s)));
    }
    return curve;
}

Pattern with_drawn_pitches(Pattern pattern) {
    pattern.frequency_curve = sounding_frequency(pattern);
    for (auto& [mark, kind] : pattern.rhythm.kinds) kind.pitch = 1.0;
    return pattern;
}

Pattern clamped(Pattern pattern) {
    pattern.amplitude_g = clamp_to(limits::kAmplitudeG, pattern.amplitude_g);
    if (pattern.carriers.empty()) pattern.carriers.emplace_back();
    if (pattern.carriers.size() > limits::kMaxCarriers) {
        pattern.carriers.resize(limits::kMaxCarriers);
    }
    for (Carrier& carrier : pattern.carriers) {
        carrier.frequency_hz = clamp_to(limits::kCarrierHz, carrier.frequency_hz);
        carrier.weight = clamp_to(limits::kCarrierWeight, carrier.weight);
        carrier.phase_rad = clamp_to(limits::kPhaseRad, carrier.phase_rad);
    }
    pattern.modulation.frequency_hz =
        clamp_to(limits::kModulationHz, pattern.modulation.frequency_hz);
    pattern.modulation.depth = clamp_to(limits::kDepth, pattern.modulation.depth);
    pattern.rhythm.unit_s = clamp_to(limits::kRhythmUnitS, pattern.rhythm.unit_s);
    for (auto& [mark, kind] : pattern.rhythm.kinds) {
        kind = {clamp_to(limits::kVelocity, kind.velocity), clamp_to(limits::kPitch, kind.pitch)};
    }
    pattern.attack_s = clamp_to(limits::kRampS, pattern.attack_s);
    pattern.release_s = clamp_to(limits::kRampS, pattern.release_s);
    clamp_drawn(pattern);
    const double length_s = clamp_to(limits::kDurationS, pattern.duration_s);
    return with_duration(std::move(pattern), length_s);
}

Pattern with_duration(Pattern pattern, double duration_s) {
    pattern.duration_s = duration_s;
    cut_at(pattern.amplitude_curve, duration_s);
    cut_at(pattern.frequency_curve, duration_s);
    std::erase_if(pattern.transients,
                  [&](const Transient& transient) { return transient.time_s > duration_s; });
    return pattern;
}

bool has_accents(const Pattern& pattern) {
    return std::ranges::any_of(pattern.transients, [&pattern](const Transient& one) {
        const auto is_over = [&](double share) {
            return envelope_g(pattern, one.time_s + share * one.duration_s) > 0.0;
        };
        return one.amplitude_g > 0.0 && (is_over(0.0) || is_over(0.5) || is_over(1.0));
    });
}

bool is_drawn(const Pattern& pattern) {
    return !pattern.amplitude_curve.empty() || !pattern.frequency_curve.empty() ||
           !pattern.transients.empty();
}

double amplitude_factor(const Pattern& pattern, double t_s) {
    return value_at(pattern.amplitude_curve, t_s);
}

double first_carrier_hz(const Pattern& pattern, double t_s) {
    const double own_hz = pattern.carriers.empty() ? 0.0 : pattern.carriers.front().frequency_hz;
    const double hz = frequency_at(pattern.frequency_curve, t_s).value_or(own_hz);
    if (!has_pitches(pattern.rhythm)) return hz;
    return clamp_to(limits::kCarrierHz, hz * pitch_at(pattern.rhythm, t_s));
}

double envelope_g(const Pattern& pattern, double t_s) {
    const auto note = note_at(pattern.rhythm, pattern.duration_s, t_s);
    if (!note) return 0.0;
    const double since_onset_s = t_s - note->onset_s;
    return pattern.amplitude_g * note->velocity *
           ramp_gain(pattern, since_onset_s, note->length_s - since_onset_s) *
           amplitude_factor(pattern, t_s);
}

Waveform render(const Pattern& pattern, double rate_hz) {
    Waveform waveform = render_carriers(pattern, rate_hz);
    if (pattern.accents == Accents::joined) {
        add_accents(waveform, pattern.transients);
    } else {
        add_transients(waveform, pattern.transients);
    }
    return waveform;
}

Waveform render_carriers(const Pattern& pattern, double rate_hz) {
    Waveform waveform{rate_hz,
                      rhythm_gate(pattern, rate_hz, sample_count(pattern.duration_s, rate_hz))};
    const Sweep sweep = sweep_of(sounding_frequency(pattern));
    const bool swept = !sweep.curve.empty() && !pattern.carriers.empty();
    for (std::size_t n = 0; n < waveform.samples_g.size(); ++n) {
        const double t_s = static_cast<double>(n) / rate_hz;
        const double carriers = swept
                                    ? swept_carriers_at(pattern.carriers, sweep, t_s, 0.5 * rate_hz)
                                    : carriers_at(pattern.carriers, t_s);
        waveform.samples_g[n] *=
            pattern.amplitude_g * modulation_at(pattern.modulation, t_s) * carriers;
        waveform.samples_g[n] *= amplitude_factor(pattern, t_s);
    }
    return waveform;
}

}  // namespace tact
