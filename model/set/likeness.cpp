#include "model/set/likeness.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

#include "model/common/portable.h"
#include "model/set/layers.h"

namespace tact {

namespace {

constexpr std::size_t kParts = 24;
constexpr std::size_t kMost = 1000;

struct Rough {
    std::array<double, kParts> strength_g{};
    double hz = 0.0;      // mean, weighted by strength ...
    double weight = 0.0;  // ... and by how much
};

void add_tone(Rough& rough, std::size_t part, double strength_g, double hz) {
    rough.strength_g[part] += strength_g;
    rough.hz += strength_g * hz;
    rough.weight += strength_g;
}

void add_pattern(Rough& rough, const Pattern& pattern, double gain, double offset_s,
                 double part_s) {
    for (std::size_t part = 0; part < kParts; ++part) {
        const double t_s = (static_cast<double>(part) + 0.5) * part_s - offset_s;
        add_tone(rough, part, gain * envelope_g(pattern, t_s), first_carrier_hz(pattern, t_s));
    }
    for (const Transient& one : pattern.transients) {
        const double part = (one.time_s + offset_s) / part_s;
        const auto at = std::min(kParts - 1, static_cast<std::size_t>(std::max(0.0, part)));
        const double share = std::min(1.0, one.duration_s / part_s);
        add_tone(rough, at, gain * share * one.amplitude_g, one.frequency_hz);
    }
}

// Half the crossings of zero a second are its frequency.
void add_samples(Rough& rough, const Waveform& waveform, double gain, double offset_s,
                 double part_s) {
    const std::vector<double>& samples = waveform.samples_g;
    for (std::size_t part = 0; part < kParts; ++part) {
        const double from_s = static_cast<double>(part) * part_s - offset_s;
        const auto sample = [&](double t_s) {
            return std::min(samples.size(), sample_count(std::max(0.0, t_s), waveform.rate_hz));
        };
        const std::size_t from = sample(from_s);
        const std::size_t to = sample(from_s + part_s);
        double squares = 0.0;
        double crossings = 0.0;
        for (std::size_t n = from; n < to; ++n) {
            squares += samples[n] * samples[n];
            if (n > from && (samples[n] < 0.0) != (samples[n - 1] < 0.0)) ++crossings;
        }
        if (to == from) continue;
        const auto count = static_cast<double>(to - from);
        add_tone(rough, part, gain * std::sqrt(2.0 * squares / count),
                 0.5 * crossings * waveform.rate_hz / count);
    }
}

void add_source(Rough& rough, const std::variant<Pattern, Measurement>& source, double gain,
                double offset_s, double part_s) {
    if (const auto* pattern = std::get_if<Pattern>(&source)) {
        return add_pattern(rough, *pattern, gain, offset_s, part_s);
    }
    add_samples(rough, *std::get<Measurement>(source).waveform, gain, offset_s, part_s);
}

Rough rough_of(const Vibration& vibration, double part_s) {
    Rough rough;
    const LayeredPattern layered = as_layers(vibration.source);
    for (std::size_t k = 0; k < layered.layers.size(); ++k) {
        if (!sounds(layered, k)) continue;
        const Layer& layer = layered.layers[k];
        add_source(rough, layer.source, layer.gain, layer.offset_s, part_s);
    }
    return rough;
}

using Features = std::array<double, kParts + 1>;

std::vector<Features> features_of(const PatternSet& set) {
    const double part_s = std::max(longest_s(set), 1e-3) / static_cast<double>(kParts);
    std::vector<Rough> all;
    double strongest_g = 0.0;
    for (const Vibration& vibration : set.vibrations) {
        all.push_back(rough_of(vibration, part_s));
        strongest_g = std::max(strongest_g, std::ranges::max(all.back().strength_g));
    }
    std::vector<Features> features;
    for (const Rough& rough : all) {
        Features one{};
        for (std::size_t part = 0; part < kParts; ++part) {
            if (strongest_g > 0.0) one[part] = rough.strength_g[part] / strongest_g;
        }
        const double hz = rough.weight > 0.0 ? rough.hz / rough.weight : 0.0;
        one[kParts] = portable::log(1.0 + hz) / portable::log(2.0);
        features.push_back(one);
    }
    return features;
}

double apart(const Features& a, const Features& b) {
    double sum = 0.0;
    for (std::size_t k = 0; k < a.size(); ++k) sum += (a[k] - b[k]) * (a[k] - b[k]);
    return sum;
}

}  // namespace

std::vector<std::size_t> order_by_likeness(const PatternSet& set) {
    const std::size_t count = set.vibrations.size();
    std::vector<std::size_t> order(count);
    std::iota(order.begin(), order.end(), std::size_t{0});
    if (count < 3 || count > kMost) return order;
    const std::vector<Features> features = features_of(set);
    for (std::size_t k = 1; k < count; ++k) {
        std::size_t best = k;
        double least = std::numeric_limits<double>::infinity();
        for (std::size_t j = k; j < count; ++j) {
            const double distance = apart(features[order[k - 1]], features[order[j]]);
            if (distance < least) {
                least = distance;
                best = j;
            }
        }
        // The others keep their order, so that equal ones stay in that of the set.
        std::rotate(order.begin() + static_cast<std::ptrdiff_t>(k),
                    order.begin() + static_cast<std::ptrdiff_t>(best),
                    order.begin() + static_cast<std::ptrdiff_t>(best) + 1);
    }
    return order;
}

}  // namespace tact
