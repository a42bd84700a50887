// Patterns at random for writers, what comes back of them by our own readers with the same map, and
// whether that is equal.
#pragma once

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>

#include "model/io/formats/ahap/ahap_pair.h"
#include "model/io/formats/read_effects.h"
#include "model/io/formats/write_effect.h"
#include "model/pattern/drawn_fault.h"

namespace tact::written_patterns {

// Linear, no ducking, and one length of transients: nothing that only a map would lose.
inline ActuatorMap plain_map() {
    ActuatorMap map;
    map.name = "plain";
    map.frequency_hz = {50.0, 250.0};
    map.full_scale_g = 2.0;
    map.burst_at_0 = {60.0, 0.020, BurstShape::sine};
    map.burst_at_1 = {240.0, 0.020, BurstShape::sine};
    return map;
}

inline double between(std::mt19937& random, double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
}

inline int whole(std::mt19937& random, int low, int high) {
    return std::uniform_int_distribution<int>(low, high)(random);
}

// What a format can hold.
struct Holds {
    bool jumps = true;
    bool transients = true;
    bool begins_at_0 = false;
    double tick_s = 1e-4;  // of times
    int least_gap_ticks = 1;
    int least_points = 2;
    int most_points = 40;
    double frequency_step = 0.0;  // share of 50 to 250 Hz
};

inline double some_hz(std::mt19937& random, const Holds& holds) {
    const double share = between(random, 0.0, 1.0);
    if (holds.frequency_step == 0.0) return 50.0 + 200.0 * share;
    return 50.0 + 200.0 * holds.frequency_step * std::round(share / holds.frequency_step);
}

inline Pattern some_pattern(std::mt19937& random, const Holds& holds) {
    Pattern pattern;
    pattern.amplitude_g = 0.8;
    pattern.carriers.front().frequency_hz = some_hz(random, holds);
    const bool sweeps = whole(random, 0, 1) == 1;
    const int points = whole(random, holds.least_points, holds.most_points);
    int ticks = 0;
    for (int k = 0; k < points; ++k) {
        const double t_s = ticks * holds.tick_s;
        const double value = k == 0 && holds.begins_at_0 ? 0.0 : between(random, 0.0, 1.0);
        pattern.amplitude_curve.push_back({t_s, value});
        const bool jump = holds.jumps && k > 0 && whole(random, 0, 3) == 0;
        if (jump) pattern.amplitude_curve.push_back({t_s, between(random, 0.0, 1.0)});
        if (sweeps) pattern.frequency_curve.push_back({t_s, some_hz(random, holds)});
        pattern.duration_s = t_s;
        ticks += holds.least_gap_ticks + whole(random, 0, static_cast<int>(0.08 / holds.tick_s));
    }
    if (!holds.transients || pattern.duration_s < 0.1) return pattern;
    const int taps = whole(random, 0, 4);
    for (int k = 0; k < taps; ++k) {
        const int ms = 5 + 25 * k;
        if (1e-3 * ms > pattern.duration_s - 0.03) break;
        // As strong as some intensity from 0.6 on, and above all that is continuous.
        for (const Transient& one :
             transients_on(plain_map(), 1e-3 * ms, 0.01 * whole(random, 60, 100),
                           0.01 * whole(random, 0, 100))) {
            pattern.transients.push_back(one);
        }
    }
    return pattern;
}

inline EffectsRead read_back(const std::string& text) {
    const auto read = read_effects(text, "a.x", plain_map());
    REQUIRE_MESSAGE(read, (read ? "" : read.error().message + "\n" + text));
    REQUIRE(read->effects.size() == 1);
    REQUIRE(!drawn_fault(read->effects.front().pattern));
    return *read;
}

inline EffectsRead pair_back(const WrittenEffect& written) {
    const auto pair = joined_pair(*read_effects(written.text, "a_continuous.ahap", plain_map()),
                                  *read_effects(written.beside, "a_transients.ahap", plain_map()));
    REQUIRE(pair);
    REQUIRE(!drawn_fault(pair->effects.front().pattern));
    return *pair;
}

inline EffectsRead read_back(TargetFormat format, const WrittenEffect& written) {
    return format == TargetFormat::ahap_pair ? pair_back(written) : read_back(written.text);
}

inline double largest_difference_g(const Pattern& a, const Pattern& b) {
    double largest = 0.0;
    for (double t_s = 0.00005; t_s < a.duration_s; t_s += 0.0001) {
        largest = std::max(largest, std::abs(envelope_g(a, t_s) - envelope_g(b, t_s)));
    }
    return largest;
}

inline double largest_difference_hz(const Pattern& a, const Pattern& b) {
    double largest = 0.0;
    for (double t_s = 0.00005; t_s < a.duration_s; t_s += 0.0001) {
        if (!(envelope_g(a, t_s) > 1e-9)) continue;
        largest = std::max(largest, std::abs(first_carrier_hz(a, t_s) - first_carrier_hz(b, t_s)));
    }
    return largest;
}

inline bool same_transients(const Pattern& a, const Pattern& b) {
    return std::ranges::equal(
        a.transients, b.transients, [](const Transient& one, const Transient& other) {
            return std::abs(one.time_s - other.time_s) < 1e-9 &&
                   std::abs(one.amplitude_g - other.amplitude_g) < 1e-6 &&
                   std::abs(one.frequency_hz - other.frequency_hz) < 1e-6 &&
                   std::abs(one.duration_s - other.duration_s) < 1e-9 && one.shape == other.shape;
        });
}

// Equal in what a plain pattern has: the carrier's envelope and frequency, and transients.
inline bool is_equal(const Pattern& a, const Pattern& b) {
    return std::abs(a.duration_s - b.duration_s) < 1e-9 && largest_difference_g(a, b) < 1e-6 &&
           largest_difference_hz(a, b) < 1e-6 && same_transients(a, b);
}

}  // namespace tact::written_patterns
