#include "model/io/effects_out/on_off.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace tact {

namespace {

constexpr int kFull = 255;
constexpr int kFaintest = 21;        // 8 % of full scale
constexpr int kWithoutPause = 243;   // 95 % of full scale
constexpr Range kRatesHz{1.0, 1e9};  // of drives

// An amplitude for each ms, as a motor without amplitudes is asked for it.
struct Course {
    std::vector<std::uint8_t> asked;   // 0 to 255
    std::vector<std::int64_t> before;  // sums: of all ms before each, and of all
    int too_weak_ms = 0;

    int length_ms() const { return static_cast<int>(asked.size()); }
    std::int64_t sum(int from_ms, int to_ms) const {
        return before[static_cast<std::size_t>(to_ms)] - before[static_cast<std::size_t>(from_ms)];
    }
};

struct MsStretch {
    int from_ms = 0;
    int to_ms = 0;
};

struct FeltBurst {
    MsStretch at;
    int asked_ms = 0;  // its own length: one near the end has begun sooner, to have room
};

std::uint8_t asked_for(int amplitude) {
    if (amplitude < kFaintest) return 0;
    return static_cast<std::uint8_t>(amplitude < kWithoutPause ? amplitude : kFull);
}

Course course_of(const SteppedAmplitudes& steps) {
    Course course;
    const std::size_t count = std::min(steps.timings_ms.size(), steps.amplitudes.size());
    for (std::size_t k = 0; k < count; ++k) {
        const int length_ms = std::max(steps.timings_ms[k], 0);
        const int amplitude = std::clamp(steps.amplitudes[k], 0, kFull);
        const std::uint8_t asked = asked_for(amplitude);
        if (amplitude > 0 && asked == 0) course.too_weak_ms += length_ms;
        course.asked.insert(course.asked.end(), static_cast<std::size_t>(length_ms), asked);
    }
    const bool is_silent = std::ranges::count(course.asked, 0) == std::ssize(course.asked);
    if (!is_silent && course.length_ms() < kLeastOnMs) course.asked.resize(kLeastOnMs);
    course.before.push_back(0);
    for (const std::uint8_t asked : course.asked) {
        course.before.push_back(course.before.back() + asked);
    }
    return course;
}

// Silences that no motor can show belong to what is around them. The last 15 ms have room for one.
std::vector<FeltBurst> bursts_of(const Course& course) {
    std::vector<FeltBurst> bursts;
    for (int n = 0; n < course.length_ms(); ++n) {
        if (course.asked[static_cast<std::size_t>(n)] == 0) continue;
        const int from_ms = std::min(n, course.length_ms() - kLeastOnMs);
        if (bursts.empty() || from_ms - bursts.back().at.to_ms >= kLeastOffMs) {
            bursts.push_back({{from_ms, n}});
        }
        bursts.back().asked_ms += n + 1 - bursts.back().at.to_ms;
        bursts.back().at.to_ms = n + 1;
    }
    return bursts;
}

// Pulses and pauses as they are decided, ms by ms.
struct Playing {
    const Course& course;
    int on_ms = kLeastOnMs;  // the least within a burst
    int off_ms = kLeastOffMs;
    std::vector<MsStretch> pulses{};
};

// Whether a pause from here on would leave less owing than half of it; or, where it would last to
// the end of the burst, less than no pause would.
bool is_paid(const Playing& playing, const MsStretch& burst, int now_ms, int room_ms,
             std::int64_t owed) {
    int pause_ms = playing.off_ms;
    const bool is_last = now_ms + playing.off_ms + playing.on_ms > room_ms;
    if (is_last || now_ms + pause_ms > burst.to_ms) pause_ms = burst.to_ms - now_ms;
    const std::int64_t soon = playing.course.sum(now_ms, now_ms + pause_ms);
    return 2 * (owed + soon) <= kFull * pause_ms;
}

// Whether there is enough left of the burst for another pulse, and room before `room_ms`.
bool is_owed(const Playing& playing, const MsStretch& burst, int now_ms, int room_ms,
             std::int64_t owed) {
    if (owed < 0 || now_ms + playing.on_ms > room_ms) return false;
    if (playing.course.asked[static_cast<std::size_t>(now_ms)] == 0) return false;
    const std::int64_t left = owed + playing.course.sum(now_ms, burst.to_ms);
    return 2 * left >= kFull * playing.on_ms;
}

// The burst from `from_ms` on, which is its beginning unless another pulse was in the way.
void play(Playing& playing, const MsStretch& burst, int from_ms, int room_ms) {
    bool is_on = true;
    int since_ms = from_ms;
    std::int64_t owed = from_ms < burst.to_ms ? playing.course.sum(burst.from_ms, from_ms) : 0;
    for (int n = from_ms; n < burst.to_ms; ++n) {
        if (is_on && n - since_ms >= playing.on_ms && is_paid(playing, burst, n, room_ms, owed)) {
            playing.pulses.push_back({since_ms, n});
            is_on = false;
            since_ms = n;
        } else if (!is_on && n - since_ms >= playing.off_ms &&
                   is_owed(playing, burst, n, room_ms, owed)) {
            is_on = true;
            since_ms = n;
        }
        owed += playing.course.asked[static_cast<std::size_t>(n)] - (is_on ? kFull : 0);
    }
    if (is_on) playing.pulses.push_back({since_ms, std::max(burst.to_ms, since_ms + kLeastOnMs)});
}

std::vector<int> entries_of(const std::vector<MsStretch>& pulses, int length_ms) {
    std::vector<int> ms;
    int at_ms = 0;
    for (const MsStretch& pulse : pulses) {
        if (ms.empty() && pulse.from_ms > 0) ms.push_back(0);
        if (pulse.from_ms > 0) ms.push_back(pulse.from_ms - at_ms);
        ms.push_back(pulse.to_ms - pulse.from_ms);
        at_ms = pulse.to_ms;
    }
    if (ms.empty() && length_ms > 0) ms.push_back(0);
    if (length_ms > at_ms) ms.push_back(length_ms - at_ms);
    return ms;
}

// The greatest of each ms; a ms without a sample has that before it.
std::vector<double> peaks_of(std::span<const double> samples, double rate_hz, double level) {
    const double length_ms = std::round(1e3 * static_cast<double>(samples.size()) / rate_hz);
    std::vector<double> peaks(static_cast<std::size_t>(length_ms), 0.0);
    const auto sample_at = [&](std::size_t ms) {
        const double at = std::floor(1e-3 * rate_hz * static_cast<double>(ms));
        return std::min(static_cast<std::size_t>(at), samples.size());
    };
    for (std::size_t ms = 0; ms < peaks.size(); ++ms) {
        const std::size_t first = std::min(sample_at(ms), samples.size() - 1);
        const std::size_t behind = std::max(sample_at(ms + 1), first + 1);
        for (std::size_t n = first; n < behind; ++n) {
            const double strength = level * std::abs(samples[n]);
            if (std::isfinite(strength)) peaks[ms] = std::max(peaks[ms], strength);
        }
    }
    return peaks;
}

// What is weaker for less than the shortest pause is filled up (a morphological closing); beyond
// both ends is silence.
std::vector<double> without_dips(const std::vector<double>& peaks) {
    constexpr auto kWidth = static_cast<std::size_t>(kLeastOffMs);
    std::vector<double> widened(peaks.size() + kWidth - 1, 0.0);
    for (std::size_t n = 0; n < peaks.size(); ++n) {
        for (std::size_t k = 0; k < kWidth; ++k) {
            widened[n + k] = std::max(widened[n + k], peaks[n]);
        }
    }
    std::vector<double> filled(peaks.size(), 0.0);
    for (std::size_t n = 0; n < peaks.size(); ++n) {
        const auto first = widened.begin() + static_cast<std::ptrdiff_t>(n);
        filled[n] = *std::min_element(first, first + static_cast<std::ptrdiff_t>(kWidth));
    }
    return filled;
}

}  // namespace

OnOff on_off_of(const SteppedAmplitudes& steps, int coarser) {
    const Course course = course_of(steps);
    const std::vector<FeltBurst> bursts = bursts_of(course);
    const int factor = std::max(coarser, 1);
    Playing playing{course, factor * kLeastOnMs, factor * kLeastOffMs};
    OnOff result;
    int lost_ms = course.too_weak_ms;
    int free_ms = 0;  // no pulse may begin before
    for (std::size_t k = 0; k < bursts.size(); ++k) {
        const bool is_last = k + 1 == bursts.size();
        const int next_ms = is_last ? course.length_ms() : bursts[k + 1].at.from_ms;
        const int from_ms = std::max(bursts[k].at.from_ms, free_ms);
        // Too close behind the one before it: the next one is nearer to where a pulse may begin.
        if (from_ms + (is_last ? kLeastOnMs : 0) > next_ms) {
            lost_ms += bursts[k].asked_ms;
            continue;
        }
        if (bursts[k].asked_ms < kLeastOnMs) ++result.lengthened;
        play(playing, bursts[k].at, from_ms, is_last ? next_ms : next_ms - kLeastOffMs);
        free_ms = playing.pulses.back().to_ms + kLeastOffMs;
    }
    result.ms = entries_of(playing.pulses, course.length_ms());
    result.floor_lost_s = 1e-3 * lost_ms;
    return result;
}

OnOff on_off_of_drive(std::span<const double> samples, double rate_hz, double level) {
    const bool is_rate = rate_hz >= kRatesHz.low && rate_hz <= kRatesHz.high;
    if (!is_rate || samples.empty()) return {};
    const bool is_level = std::isfinite(level) && level > 0.0;
    SteppedAmplitudes steps;
    for (const double peak : without_dips(peaks_of(samples, rate_hz, is_level ? level : 0.0))) {
        steps.timings_ms.push_back(1);
        steps.amplitudes.push_back(static_cast<int>(std::lround(kFull * std::min(peak, 1.0))));
    }
    return on_off_of(steps);
}

}  // namespace tact
