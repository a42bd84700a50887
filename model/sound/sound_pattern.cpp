#include "model/sound/sound_pattern.h"

#include <algorithm>
#include <cmath>

#include "model/common/portable.h"
#include "model/pattern/traced.h"
#include "model/signal/cut_and_fade.h"
#include "model/signal/spectrum.h"
#include "model/text/numbers.h"

namespace tact {

namespace {

constexpr double kBesideOctaves = 1.0 / 6.0;
constexpr double kFadeOctaves = 0.5;
constexpr double kSectionS = 1.0;

Range widened(Range band_hz) {
    const double ratio = portable::pow(2.0, kBesideOctaves);
    return {band_hz.low / ratio, band_hz.high * ratio};
}

double energy_of(const Waveform& waveform) {
    double sum = 0.0;
    for (const double sample : waveform.samples_g) sum += sample * sample;
    return sum;
}

// What the actuator cannot do is asked of it at the edge of its band.
void keep_within(Pattern& pattern, Range band_hz) {
    const auto within = [&](double& hz) { hz = std::clamp(hz, band_hz.low, band_hz.high); };
    within(pattern.carriers.front().frequency_hz);
    for (FrequencyPoint& point : pattern.frequency_curve) within(point.frequency_hz);
    for (Transient& transient : pattern.transients) within(transient.frequency_hz);
    const auto is_steady = [&](const FrequencyPoint& point) {
        return point.frequency_hz == pattern.carriers.front().frequency_hz;
    };
    if (std::ranges::all_of(pattern.frequency_curve, is_steady)) pattern.frequency_curve.clear();
}

std::string hz_text(Range band_hz) {
    return significant_digits(band_hz.low, 4) + " to " + significant_digits(band_hz.high, 4) +
           " Hz";
}

}  // namespace

Waveform felt_in_band(const Waveform& sound, Range band_hz) {
    const Range flat_hz = widened(band_hz);
    const auto gain = [flat_hz](double hz) {
        if (!(hz > 0.0)) return 0.0;
        const double off = hz < flat_hz.low    ? portable::log2(flat_hz.low / hz)
                           : hz > flat_hz.high ? portable::log2(hz / flat_hz.high)
                                               : 0.0;
        return off >= kFadeOctaves ? 0.0 : fade_gain(kFadeOctaves - off, kFadeOctaves);
    };
    return {sound.rate_hz, zero_phase_filtered(sound.samples_g, sound.rate_hz, gain)};
}

SoundPattern pattern_of_sound(const Waveform& sound, const SoundOptions& options) {
    SoundPattern made;
    const Waveform scaled = with_gain(sound, options.full_scale_g);
    made.felt = felt_in_band(scaled, options.band_hz);
    const double all = energy_of(scaled);
    if (all > 0.0) made.outside_share = std::clamp(1.0 - energy_of(made.felt) / all, 0.0, 1.0);
    TraceParams params;
    params.most_points = std::max<std::size_t>(options.points_per_s, 2);
    params.section_s = kSectionS;
    params.band_hz = widened(options.band_hz);
    params.transients = options.accents;
    TracedPattern traced_sound = traced(made.felt, params);
    made.pattern = std::move(traced_sound.pattern);
    made.amplitude_error_g = traced_sound.amplitude_error_g;
    made.frequency_error_hz = traced_sound.frequency_error_hz;
    made.frequency_is_a_guess = traced_sound.frequency_is_a_guess;
    made.other_share = traced_sound.other_share;
    keep_within(made.pattern, options.band_hz);
    const double peak = peak_g(made.felt);
    if (peak > limits::kAmplitudeG.high) made.over_g = peak;
    return made;
}

std::vector<std::string> words_of(const SoundPattern& made, const SoundOptions& options) {
    constexpr double kMuch = 0.05;
    std::vector<std::string> words;
    const Pattern& pattern = made.pattern;
    const std::size_t points = pattern.amplitude_curve.size() + pattern.frequency_curve.size();
    words.push_back(significant_digits(pattern.duration_s, 4) + " s, " +
                    counted(points, "point of a curve", "points of curves") + " and " +
                    counted(pattern.transients.size(), "accent", "accents"));
    if (made.frequency_is_a_guess) {
        words.push_back("too short to measure its frequency: " +
                        significant_digits(pattern.carriers[0].frequency_hz, 3) +
                        " Hz are a guess");
    }
    if (made.other_share > kMuch) {
        words.push_back(percent(made.other_share) +
                        " of what can be felt has other frequencies than the strongest one, or is "
                        "noise: its strength is kept, its roughness is not");
    }
    if (made.outside_share > kMuch) {
        words.push_back(percent(made.outside_share) + " of the sound's energy lies outside of " +
                        hz_text(options.band_hz) + " and is not felt");
    }
    if (made.over_g > 0.0) {
        words.push_back("its peak of " + significant_digits(made.over_g, 3) +
                        " g is beyond the 50 g that a pattern may have");
    }
    return words;
}

}  // namespace tact
