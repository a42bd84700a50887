#include "model/pattern/pattern.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <numeric>
#include <optional>
#include <vector>

#include "model/common/portable.h"
#include "model/pattern/accents.h"
#include "model/pattern/pattern_numbers.h"

namespace tact {

namespace {

constexpr double kTurn = 2.0 * std::numbers::pi;

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

// Points of a curve over time, at most two at one time: of three the first and the last stay.
void append_frequency(FrequencyCurve& curve, double time_s, double hz) {
    const FrequencyPoint point{time_s, numbers::kCarrier.clamped(hz)};
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
    return numbers::kCarrier.clamped(hz * pitch_at(pattern.rhythm, t_s));
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

namespace {

constexpr double kSame = 1e-9;
constexpr double kUsPerS = 1e6;
constexpr std::int64_t kLeastUnitUs = 1000;

// From one time to another at one height.
struct Piece {
    double from_s;
    double to_s;
    double height;
};

bool is_near(double a, double b) { return std::abs(a - b) <= kSame * std::max(1.0, std::abs(a)); }

constexpr double kGlides = std::numeric_limits<double>::quiet_NaN();

// The curve's pieces until the end, with kGlides as the height of one that is not flat.
template <class Point>
std::vector<Piece> pieces_of(const std::vector<Point>& curve, double end_s) {
    std::vector<Piece> pieces;
    const auto add = [&](double from_s, double to_s, double height) {
        if (!(to_s > from_s)) return;
        if (!pieces.empty() && is_near(pieces.back().height, height)) {
            pieces.back().to_s = to_s;
        } else {
            pieces.push_back({from_s, to_s, height});
        }
    };
    add(0.0, std::min(curve.front().time_s, end_s), height_of(curve.front()));
    for (std::size_t k = 1; k < curve.size(); ++k) {
        const Point& a = curve[k - 1];
        const Point& b = curve[k];
        const bool is_flat = is_near(height_of(a), height_of(b));
        add(a.time_s, std::min(b.time_s, end_s), is_flat ? height_of(a) : kGlides);
    }
    add(std::min(curve.back().time_s, end_s), end_s, height_of(curve.back()));
    return pieces;
}

// A note by its time, strength and frequency.
struct FoundNote {
    double from_s;
    double to_s;
    double velocity;
    double hz;
};

// What sounds of pieces of strength, cut where the frequency changes; empty where anything glides.
std::vector<FoundNote> notes_of(const std::vector<Piece>& strengths, const std::vector<Piece>& hz) {
    std::vector<FoundNote> found;
    std::size_t first = 0;
    for (const Piece& strength : strengths) {
        if (std::isnan(strength.height)) return {};
        if (strength.height <= 0.0) continue;
        while (first + 1 < hz.size() && hz[first].to_s <= strength.from_s) ++first;
        for (std::size_t k = first; k < hz.size() && hz[k].from_s < strength.to_s; ++k) {
            if (std::isnan(hz[k].height)) return {};
            found.push_back({std::max(strength.from_s, hz[k].from_s),
                             std::min(strength.to_s, hz[k].to_s), strength.height, hz[k].height});
        }
    }
    return found;
}

// The time in whole us; none where it is no whole number of them.
std::optional<std::int64_t> whole_us(double t_s) {
    const double us = std::round(t_s * kUsPerS);
    if (std::abs(t_s * kUsPerS - us) > 1e-3) return std::nullopt;
    return static_cast<std::int64_t>(us);
}

// The longest step that all beginnings and ends are multiples of, but for the pattern's end.
std::optional<std::int64_t> unit_us(const std::vector<FoundNote>& found, double end_s) {
    std::int64_t unit = 0;
    for (const FoundNote& note : found) {
        for (const double t_s : {note.from_s, note.to_s}) {
            if (t_s >= end_s) continue;
            const auto us = whole_us(t_s);
            if (!us) return std::nullopt;
            unit = std::gcd(unit, *us);
        }
    }
    const auto end_us = whole_us(end_s);
    if (unit == 0) unit = end_us.value_or(0);
    if (end_us && std::gcd(unit, *end_us) >= kLeastUnitUs) unit = std::gcd(unit, *end_us);
    const double most_us = kUsPerS * limits::kRhythmUnitS.high;
    if (unit < kLeastUnitUs || static_cast<double>(unit) > most_us) return std::nullopt;
    return unit;
}

// The rhythm's text and kinds; false where a note has no mark.
bool write_notes(Rhythm& rhythm, const std::vector<FoundNote>& found, std::int64_t unit,
                 double first_hz) {
    const auto step_of = [unit](double t_s) {
        const double steps = t_s * kUsPerS / static_cast<double>(unit);
        return static_cast<std::size_t>(std::ceil(steps - 1e-6));
    };
    for (const FoundNote& note : found) {
        const NoteKind kind{note.velocity, is_near(note.hz, first_hz) ? 1.0 : note.hz / first_hz};
        if (!limits::kPitch.contains(kind.pitch)) return false;
        const auto mark = mark_for(rhythm, kind);
        if (!mark) return false;
        const std::size_t first = step_of(note.from_s);
        const std::size_t end = std::min(step_of(note.to_s), rhythm.text.size());
        if (end <= first) return false;
        rhythm.text[first] = *mark;
        for (std::size_t step = first + 1; step < end; ++step) rhythm.text[step] = '=';
    }
    return true;
}

}  // namespace

std::optional<Pattern> with_found_notes(const Pattern& pattern) {
    const bool has_notes =
        !pattern.rhythm.text.empty() || pattern.attack_s > 0.0 || pattern.release_s > 0.0;
    if (has_notes || pattern.amplitude_curve.empty() || pattern.carriers.empty()) return {};
    const double end_s = pattern.duration_s;
    FrequencyCurve curve = pattern.frequency_curve;
    if (curve.empty()) curve = {{0.0, pattern.carriers.front().frequency_hz}};
    const std::vector<FoundNote> found =
        notes_of(pieces_of(pattern.amplitude_curve, end_s), pieces_of(curve, end_s));
    const bool is_steady = found.size() == 1 && found[0].from_s == 0.0 && found[0].to_s >= end_s;
    if (found.empty() || is_steady) return {};
    const auto unit = unit_us(found, end_s);
    if (!unit) return {};
    const double steps = std::ceil(end_s * kUsPerS / static_cast<double>(*unit) - 1e-6);
    if (steps > static_cast<double>(kMaxRhythmSteps)) return {};
    Pattern with_notes = pattern;
    Rhythm& rhythm = with_notes.rhythm;
    rhythm.text = std::string(static_cast<std::size_t>(steps), '-');
    rhythm.unit_s = static_cast<double>(*unit) / kUsPerS;
    const double first_hz = found.front().hz;
    if (!write_notes(rhythm, found, *unit, first_hz)) return {};
    if (!pattern.frequency_curve.empty()) {
        const double by = first_hz / pattern.carriers.front().frequency_hz;
        for (Carrier& carrier : with_notes.carriers) carrier.frequency_hz *= by;
        with_notes.carriers.front().frequency_hz = first_hz;
    }
    with_notes.amplitude_curve.clear();
    with_notes.frequency_curve.clear();
    return with_notes;
}

}  // namespace tact
