#include "model/pattern/same_vibration.h"

#include <algorithm>
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

// Carriers that sound, by frequency and phase; those of one frequency and phase as one.
std::vector<Carrier> sounding(const Pattern& pattern) {
    std::vector<Carrier> carriers = pattern.carriers;
    for (Carrier& carrier : carriers) carrier.weight *= pattern.amplitude_g;
    std::ranges::sort(carriers, {}, [](const Carrier& c) {
        return std::tuple(c.frequency_hz, c.phase_rad, c.weight);
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
    const bool am = modulation.kind == ModulationKind::am;
    if (modulation.frequency_hz == 0.0 || (am && modulation.depth == 0.0)) return;
    numbers.push_back(am ? 2.0 : 1.0);
    numbers.push_back(rounded(modulation.frequency_hz));
    if (am) numbers.push_back(rounded(modulation.depth));
}

// First and last sample of every note. Without ramps, notes that touch are one.
void add_notes(std::vector<double>& numbers, const Pattern& pattern) {
    const bool ramps = pattern.attack_s > 0.0 || pattern.release_s > 0.0;
    const std::size_t before = numbers.size();
    for (const Note& note : notes(pattern.rhythm, pattern.duration_s)) {
        const auto at = [](double s) { return static_cast<double>(sample_count(s, kModelRateHz)); };
        const double begin = at(note.onset_s);
        const double end = at(note.onset_s + note.length_s);
        if (!ramps && numbers.size() > before && numbers.back() == begin) {
            numbers.back() = end;
        } else {
            numbers.insert(numbers.end(), {begin, end});
        }
    }
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
    const std::vector<Carrier> carriers = sounding(pattern);
    if (carriers.empty()) return numbers;
    const std::size_t silent = numbers.size();
    add_notes(numbers, pattern);
    if (numbers.size() == silent) return numbers;
    numbers.insert(numbers.end(), {-1.0, rounded(pattern.attack_s), rounded(pattern.release_s)});
    add_modulation(numbers, pattern.modulation);
    for (const Carrier& carrier : carriers) {
        numbers.insert(numbers.end(), {-2.0, rounded(carrier.frequency_hz), rounded(carrier.weight),
                                       rounded(carrier.phase_rad)});
    }
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
