#include "model/pattern/accents.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "model/common/portable.h"
#include "model/signal/waveform.h"

namespace tact {

namespace {

constexpr double kFlankShare = 0.25;
constexpr double kLeastChange = 0.04;  // of a transient's energy, 0.2 dB

// The samples that a transient may touch.
struct Span {
    std::size_t first;
    std::size_t end;
};

Span span_of(const Transient& transient, const Waveform& waveform) {
    const double rate_hz = waveform.rate_hz;
    const auto first = static_cast<std::size_t>(std::max(0.0, transient.time_s) * rate_hz);
    const std::size_t end = first + sample_count(transient.duration_s, rate_hz) + 2;
    return {first, std::min(end, waveform.samples_g.size())};
}

double since_s(const Transient& transient, const Waveform& waveform, std::size_t n) {
    return static_cast<double>(n) / waveform.rate_hz - transient.time_s;
}

// The sum of products of the transient, begun at that phase, and the waveform.
double product(const Transient& transient, const Waveform& waveform, Span span, double turns) {
    double sum = 0.0;
    for (std::size_t n = span.first; n < span.end; ++n) {
        if (waveform.samples_g[n] == 0.0) continue;
        sum +=
            waveform.samples_g[n] * transient_g(transient, since_s(transient, waveform, n), turns);
    }
    return sum;
}

// Half a turn later the product has the other sign, so that between there is a phase without one.
double phase_without_product(const Transient& transient, const Waveform& waveform, Span span) {
    constexpr int kHalvings = 24;
    const double at_zero = product(transient, waveform, span, 0.0);
    if (at_zero == 0.0) return 0.0;
    double low = 0.0;
    double high = 0.5;
    for (int k = 0; k < kHalvings; ++k) {
        const double middle = 0.5 * (low + high);
        const bool same = (product(transient, waveform, span, middle) > 0.0) == (at_zero > 0.0);
        (same ? low : high) = middle;
    }
    return 0.5 * (low + high);
}

double own_energy(const Transient& transient, const Waveform& waveform, Span span) {
    double sum = 0.0;
    for (std::size_t n = span.first; n < span.end; ++n) {
        const double g = transient_g(transient, since_s(transient, waveform, n), 0.0);
        sum += g * g;
    }
    return sum;
}

// Whether the transient's phase against the carriers could change its energy.
bool is_over(const Transient& transient, const Waveform& carriers, Span span) {
    const double at_zero = product(transient, carriers, span, 0.0);
    const double at_quarter = product(transient, carriers, span, 0.25);
    return 2.0 * std::sqrt(at_zero * at_zero + at_quarter * at_quarter) >
           kLeastChange * own_energy(transient, carriers, span);
}

double joining_turns(const Transient& transient, const Waveform& carriers, const Waveform& under) {
    const Span span = span_of(transient, under);
    if (!is_over(transient, carriers, span)) return 0.0;
    const double turns = phase_without_product(transient, under, span);
    const Span half{span.first, (span.first + span.end) / 2};
    return product(transient, under, half, turns) < 0.0 ? turns + 0.5 : turns;
}

void add(Waveform& waveform, const Transient& transient, double turns) {
    const Span span = span_of(transient, waveform);
    for (std::size_t n = span.first; n < span.end; ++n) {
        waveform.samples_g[n] += transient_g(transient, since_s(transient, waveform, n), turns);
    }
}

}  // namespace

double transient_g(const Transient& transient, double since_s, double phase_turns) {
    if (since_s < 0.0 || since_s >= transient.duration_s) return 0.0;
    const double flank_s = kFlankShare * transient.duration_s;
    const double edge_s = std::min(since_s, transient.duration_s - since_s);
    const double level = transient.amplitude_g * fade_gain(edge_s, flank_s);
    const double turns = transient.frequency_hz * since_s + phase_turns;
    if (transient.shape == TransientShape::sine) {
        return level * portable::sin(2.0 * std::numbers::pi * turns);
    }
    // A half turn ends where it should although 0.1 + 0.2 is not 0.3.
    constexpr double kRounding = 1e-9;
    return std::fmod(std::floor(2.0 * turns + kRounding), 2.0) == 0.0 ? level : -level;
}

void add_transients(Waveform& waveform, const std::vector<Transient>& transients) {
    for (const Transient& one : transients) add(waveform, one, 0.0);
}

void add_accents(Waveform& waveform, std::vector<Transient> transients) {
    if (transients.empty()) return;
    const Waveform carriers = waveform;
    std::ranges::stable_sort(transients, {}, &Transient::time_s);
    for (auto first = transients.begin(); first != transients.end();) {
        const auto behind = std::find_if(first, transients.end(), [&](const Transient& one) {
            return one.time_s != first->time_s;
        });
        std::vector<double> turns;
        for (auto one = first; one != behind; ++one) {
            turns.push_back(joining_turns(*one, carriers, waveform));
        }
        for (std::size_t k = 0; k < turns.size(); ++k, ++first) add(waveform, *first, turns[k]);
    }
}

}  // namespace tact
