#include "model/pattern/pattern.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "model/common/portable.h"

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
            double gain = 1.0;
            if (pattern.attack_s > 0.0) gain = std::min(gain, since_onset_s / pattern.attack_s);
            if (pattern.release_s > 0.0) gain = std::min(gain, until_end_s / pattern.release_s);
            gate[n] = gain;
        }
    }
    return gate;
}

}  // namespace

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
    pattern.attack_s = clamp_to(limits::kRampS, pattern.attack_s);
    pattern.release_s = clamp_to(limits::kRampS, pattern.release_s);
    pattern.duration_s = clamp_to(limits::kDurationS, pattern.duration_s);
    return pattern;
}

Waveform render(const Pattern& pattern, double rate_hz) {
    Waveform waveform{rate_hz,
                      rhythm_gate(pattern, rate_hz, sample_count(pattern.duration_s, rate_hz))};
    for (std::size_t n = 0; n < waveform.samples_g.size(); ++n) {
        const double t_s = static_cast<double>(n) / rate_hz;
        waveform.samples_g[n] *= pattern.amplitude_g * modulation_at(pattern.modulation, t_s) *
                                 carriers_at(pattern.carriers, t_s);
    }
    return waveform;
}

}  // namespace tact
