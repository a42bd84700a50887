// Notes of a rhythm where curves are flat between jumps. Declared in model/pattern/pattern.h.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>
#include <optional>
#include <vector>

#include "model/pattern/pattern.h"

namespace tact {

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
