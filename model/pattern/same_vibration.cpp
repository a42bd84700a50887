#include "model/pattern/same_vibration.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <tuple>

#include "model/common/portable.h"
#include "model/common/random.h"

namespace tact {

namespace {

// To twelve digits: 3 x 0.1 and 0.3 are meant to be one number.
double rounded(double value) {
    if (value == 0.0) return 0.0;
    const double scale = portable::pow(10.0, 11.0 - std::floor(portable::log10(std::abs(value))));
    return std::round(value * scale) / scale;
}

template <class Point>
bool is_flat(const std::vector<Point>& curve, double Point::*height) {
    return std::ranges::all_of(curve,
                               [&](const Point& p) { return p.*height == curve.front().*height; });
}

// With curves that are flat as the numbers that they stand for, and with carriers as multiples of
// the first one where that is drawn.
Pattern plainly(Pattern pattern) {
    AmplitudeCurve& amplitude = pattern.amplitude_curve;
    if (!amplitude.empty() && is_flat(amplitude, &AmplitudePoint::value)) {
        pattern.amplitude_g *= amplitude.front().value;
        amplitude.clear();
    }
    FrequencyCurve& frequency = pattern.frequency_curve;
    if (frequency.empty() || pattern.carriers.empty()) return pattern;
    const bool steady = is_flat(frequency, &FrequencyPoint::frequency_hz);
    const double by_hz = steady ? frequency.front().frequency_hz : 1.0;
    const double first_hz = pattern.carriers.front().frequency_hz;
    for (Carrier& carrier : pattern.carriers) {
        carrier.frequency_hz = rounded(by_hz * (carrier.frequency_hz / first_hz));
    }
    if (steady) frequency.clear();
    return pattern;
}

// Carriers that sound, by frequency and phase; those of one frequency and phase as one.
std::vector<Carrier> sounding(const Pattern& pattern) {
    std::vector<Carrier> carriers = pattern.carriers;
    for (Carrier& carrier : carriers) carrier.weight *= pattern.amplitude_g;
    std::ranges::sort(carriers, {}, [](const Carrier& carrier) {
        const auto& [frequency_hz, weight, phase_rad] = carrier;
        return std::tuple(frequency_hz, phase_rad, weight);
    });
    std::vector<Carrier> merged;
    for (const Carrier& carrier : carriers) {
        const bool again = !merged.empty() && merged.back().frequency_hz == carrier.frequency_hz &&
                           merged.back().phase_rad == carrier.phase_rad;
        if (again) merged.back().weight += carrier.weight;
        if (!again) merged.push_back(carrier);
    }
    std::erase_if(merged, [](const Carrier& carrier) { return carrier.weight == 0.0; });
    return merged;
}

void add_modulation(std::vector<double>& numbers, const Modulation& modulation) {
    const auto& [kind, frequency_hz, depth] = modulation;
    const bool am = kind == ModulationKind::am;
    if (frequency_hz == 0.0 || (am && depth == 0.0)) return;
    numbers.push_back(am ? 2.0 : 1.0);
    numbers.push_back(rounded(frequency_hz));
    if (am) numbers.push_back(rounded(depth));
}

// First and last sample of every note, and its strength where that is not the whole one. Without
// ramps, notes of one strength that touch are one.
void add_notes(std::vector<double>& numbers, const Pattern& pattern) {
    const bool ramps = pattern.attack_s > 0.0 || pattern.release_s > 0.0;
    std::vector<Note> merged;
    for (const Note& note : notes(pattern.rhythm, pattern.duration_s)) {
        const auto at = [](double s) { return static_cast<double>(sample_count(s, kModelRateHz)); };
        const double begin = at(note.onset_s);
        const double length = at(note.onset_s + note.length_s) - begin;
        const bool touches = !merged.empty() && merged.back().velocity == note.velocity &&
                             merged.back().onset_s + merged.back().length_s == begin;
        if (!ramps && touches) {
            merged.back().length_s += length;
        } else {
            merged.push_back({begin, length, note.velocity});
        }
    }
    for (const Note& note : merged) {
        numbers.insert(numbers.end(), {note.onset_s, note.onset_s + note.length_s});
        if (note.velocity < 1.0) numbers.insert(numbers.end(), {-6.0, note.velocity});
    }
}

// Each behind a number that begins nothing else.
void add_curves(std::vector<double>& numbers, const Pattern& pattern) {
    for (const AmplitudePoint& point : pattern.amplitude_curve) {
        numbers.insert(numbers.end(), {-3.0, rounded(point.time_s), rounded(point.value)});
    }
    for (const FrequencyPoint& point : pattern.frequency_curve) {
        numbers.insert(numbers.end(), {-4.0, rounded(point.time_s), rounded(point.frequency_hz)});
    }
}

void add_transients(std::vector<double>& numbers, const Pattern& pattern) {
    std::vector<std::array<double, 6>> all;
    for (const Transient& one : pattern.transients) {
        if (one.amplitude_g == 0.0 || one.time_s >= pattern.duration_s) continue;
        all.push_back({-5.0, rounded(one.time_s), rounded(one.amplitude_g),
                       rounded(one.frequency_hz), rounded(one.duration_s),
                       one.shape == TransientShape::sine ? 0.0 : 1.0});
    }
    std::ranges::sort(all);
    if (!all.empty() && pattern.accents == Accents::added) numbers.push_back(-6.0);
    for (const auto& one : all) numbers.insert(numbers.end(), one.begin(), one.end());
}

// What the carriers are; nothing of it where they are silent.
void add_carriers(std::vector<double>& numbers, const Pattern& pattern) {
    const std::vector<Carrier> carriers = sounding(pattern);
    if (carriers.empty()) return;
    const std::size_t silent = numbers.size();
    add_notes(numbers, pattern);
    if (numbers.size() == silent) return;
    numbers.insert(numbers.end(), {-1.0, rounded(pattern.attack_s), rounded(pattern.release_s)});
    add_modulation(numbers, pattern.modulation);
    for (const auto& [frequency_hz, weight, phase_rad] : carriers) {
        numbers.insert(numbers.end(),
                       {-2.0, rounded(frequency_hz), rounded(weight), rounded(phase_rad)});
    }
    add_curves(numbers, pattern);
}

std::uint64_t digest_of(std::span<const double> numbers) {
    std::uint64_t digest = numbers.size();
    for (const double number : numbers) {
        digest = random_bits(digest, std::bit_cast<std::uint64_t>(number));
    }
    return digest;
}

}  // namespace

std::vector<double> essence(const Pattern& pattern) {
    std::vector<double> numbers{
        static_cast<double>(sample_count(pattern.duration_s, kModelRateHz))};
    add_carriers(numbers, plainly(with_drawn_pitches(pattern)));
    add_transients(numbers, pattern);
    return numbers;
}

bool SeenVibrations::add(const Pattern& pattern) {
    const std::vector<double> own = essence(pattern);
    const std::uint64_t digest = digest_of(own);
    const auto [first, last] = by_digest.equal_range(digest);
    for (auto at = first; at != last; ++at) {
        if (essence(at->second) == own) return false;
    }
    by_digest.emplace(digest, pattern);
    return true;
}

}  // namespace tact
