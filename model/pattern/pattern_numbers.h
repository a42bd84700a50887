// Every number of a pattern, described once (model/text/described.h), in the order of files.
//
// Left out  a rhythm's text, and its tempo, which is its step once more: model/io/set. How times of
//           what is drawn lie to one another: model/pattern/drawn_fault.h.
#pragma once

#include <array>
#include <limits>

#include "model/pattern/pattern.h"
#include "model/text/described.h"

namespace tact {

inline constexpr std::array<const char*, 2> kModulationKinds{"product", "am"};
inline constexpr std::array<const char*, 2> kAccents{"joined", "added"};
inline constexpr std::array<const char*, 2> kTransientShapes{"sine", "square"};

namespace numbers {

// clang-format off
inline constexpr Number kAmplitude{.key = "amplitude_g", .label = "Amplitude", .format = "%.3g g",
    .range = limits::kAmplitudeG, .slider = {0.0, 4.0}, .step = 0.05, .snap = 0.01,
    .help = "Peak acceleration of the sum of carriers.", .kept = Kept::always};
inline constexpr Number kTransientPeak =
    kAmplitude.as("amplitude_g", "Peak", "Peak acceleration of the transient.");
// A field steps and snaps by 1 / duration, so that no energy leaks between bins.
inline constexpr Number kCarrier{.key = "frequency_hz", .label = "Carrier", .format = "%.5g Hz",
    .range = limits::kCarrierHz, .slider = {10.0, 500.0}, .logarithmic = true,
    .help = "Frequency of the sine, in steps that do not leak.", .kept = Kept::always};
inline constexpr Number kWeight{.key = "weight", .label = "Weight", .format = "%.3g",
    .range = limits::kCarrierWeight, .slider = {0.0, 1.0}, .step = 0.05, .snap = 0.01,
    .help = "Factor of this carrier in the sum.", .kept = Kept::always};
inline constexpr Number kPhase{.key = "phase_rad", .label = "Phase", .format = "%.4g rad",
    .range = limits::kPhaseRad, .slider = {-3.15, 3.15}, .step = 0.1,
    .help = "Phase of this carrier at the beginning."};
inline constexpr Number kModulation{.key = "frequency_hz", .label = "Modulation",
    .format = "%.4g Hz", .range = limits::kModulationHz, .slider = {0.0, 100.0},
    .help = "Frequency of the amplitude modulation; 0: not modulated.", .kept = Kept::always};
inline constexpr Number kDepth{.key = "depth", .label = "Depth", .format = "%.3g",
    .range = limits::kDepth, .slider = limits::kDepth, .step = 0.05, .snap = 0.01,
    .help = "m of 1 + m sin(2 pi f t)."};
inline constexpr Number kRhythmUnit{.key = "unit_s", .label = "Step", .format = "%.4g ms",
    .range = limits::kRhythmUnitS, .slider = {0.005, 0.5}, .times = 1000.0, .step = 5.0,
    .snap = 1.0, .logarithmic = true,
    .help = "Length of one x, = or -. The text repeats to fill the duration.",
    .kept = Kept::always};
inline constexpr Number kStepsABeat{.key = "steps_a_beat", .label = "Beat", .format = "%.0f steps",
    .range = limits::kStepsABeat, .slider = {1.0, 8.0}, .snap = 1.0,
    .help = "How many steps are a beat; no step gets longer or shorter by it."};
inline constexpr Number kBeatsABar{.key = "beats_a_bar", .label = "Bar", .format = "%.0f beats",
    .range = limits::kBeatsABar, .slider = {0.0, 8.0}, .snap = 1.0,
    .help = "How many beats are a bar: lines in the strip. 0: no bars."};
inline constexpr Number kVelocity{.key = "velocity", .label = "Strength", .format = "%.3g %%",
    .range = limits::kVelocity, .slider = limits::kVelocity, .times = 100.0, .step = 5.0,
    .snap = 1.0, .help = "How strong the notes of this letter are, as a share of the amplitude."};
inline constexpr Number kPitch{.key = "pitch", .label = "pitch", .format = "%.4g x",
    .range = limits::kPitch, .slider = {0.25, 4.0}, .step = 0.1, .snap = 0.05, .logarithmic = true,
    .help = "What the carriers' frequencies are multiplied by for its notes."};
inline constexpr Number kAttack{.key = "attack_s", .label = "Attack", .format = "%.4g ms",
    .range = limits::kRampS, .slider = {0.0, 0.5}, .times = 1000.0, .step = 5.0, .snap = 1.0,
    .help = "Linear rise at the beginning of every note."};
inline constexpr Number kRelease =
    kAttack.as("release_s", "Release", "Linear fall at the end of every note.");
inline constexpr Number kDuration{.key = "duration_s", .label = "Duration", .format = "%.4g s",
    .range = limits::kDurationS, .slider = {0.05, 10.0}, .step = 0.05, .snap = 0.05,
    .logarithmic = true,
    .help = "The model was validated at 1 s. Shorter patterns of a set are padded with silence to "
            "its longest."};
// Where a point or a transient may lie is known with the pattern: drawn_fault.h, room_of().
inline constexpr Number kTime{.key = "time_s", .label = "At", .format = "%.5g ms",
    .range = {std::numeric_limits<double>::lowest(), std::numeric_limits<double>::max()},
    .slider = {0.0, 1.0}, .times = 1000.0, .step = 5.0, .snap = 1.0,
    .help = "Since the beginning, within the pattern.", .kept = Kept::needed};
inline constexpr Number kCurveValue{.key = "value", .label = "Share of amplitude",
    .format = "%.4g %%", .range = limits::kCurveValue, .slider = limits::kCurveValue,
    .times = 100.0, .step = 5.0, .snap = 1.0,
    .help = "The pattern's amplitude is multiplied by it here.", .kept = Kept::needed};
inline constexpr Number kPointFrequency{.key = "frequency_hz", .label = "Frequency",
    .format = "%.4g Hz", .range = limits::kCarrierHz, .slider = {20.0, 500.0}, .step = 5.0,
    .snap = 1.0, .help = "Frequency of the first carrier here.", .kept = Kept::needed};
inline constexpr Number kTransientFrequency =
    kPointFrequency.as("frequency_hz", "Frequency", "Frequency of the transient.")
        .with(Kept::always);
inline constexpr Number kTransientDuration{.key = "duration_s", .label = "Length",
    .format = "%.4g ms", .range = limits::kTransientS, .slider = {0.001, 0.1}, .times = 1000.0,
    .step = 5.0, .snap = 1.0, .help = "How long the transient lasts.", .kept = Kept::always};
// clang-format on

}  // namespace numbers

template <class Visit>
void describe(Of<Carrier>, Visit&& visit) {
    visit(numbers::kCarrier, &Carrier::frequency_hz);
    visit(numbers::kWeight, &Carrier::weight);
    visit(numbers::kPhase, &Carrier::phase_rad);
}

template <class Visit>
void describe(Of<Modulation>, Visit&& visit) {
    visit("kind", OneOf{kModulationKinds, Kept::always}, &Modulation::kind);
    visit(numbers::kModulation, &Modulation::frequency_hz);
    visit(numbers::kDepth, &Modulation::depth);
}

template <class Visit>
void describe(Of<Meter>, Visit&& visit) {
    visit(numbers::kStepsABeat, &Meter::steps_a_beat);
    visit(numbers::kBeatsABar, &Meter::beats_a_bar);
}

template <class Visit>
void describe(Of<NoteKind>, Visit&& visit) {
    visit(numbers::kVelocity, &NoteKind::velocity);
    visit(numbers::kPitch, &NoteKind::pitch);
}

template <class Visit>
void describe(Of<Rhythm>, Visit&& visit) {
    visit(numbers::kRhythmUnit, &Rhythm::unit_s);
    visit("", &Rhythm::meter);  // keys of the rhythm itself
    visit("notes", &Rhythm::kinds);
}

template <class Visit>
void describe(Of<AmplitudePoint>, Visit&& visit) {
    visit(numbers::kTime, &AmplitudePoint::time_s);
    visit(numbers::kCurveValue, &AmplitudePoint::value);
}

template <class Visit>
void describe(Of<FrequencyPoint>, Visit&& visit) {
    visit(numbers::kTime, &FrequencyPoint::time_s);
    visit(numbers::kPointFrequency, &FrequencyPoint::frequency_hz);
}

template <class Visit>
void describe(Of<Transient>, Visit&& visit) {
    visit(numbers::kTime, &Transient::time_s);
    visit(numbers::kTransientPeak, &Transient::amplitude_g);
    visit(numbers::kTransientFrequency, &Transient::frequency_hz);
    visit(numbers::kTransientDuration, &Transient::duration_s);
    visit("shape", OneOf{kTransientShapes, Kept::always}, &Transient::shape);
}

template <class Visit>
void describe(Of<Pattern>, Visit&& visit) {
    visit(numbers::kAmplitude, &Pattern::amplitude_g);
    visit(ManyOf{"carriers", 1, limits::kMaxCarriers, Kept::always}, &Pattern::carriers);
    visit("modulation", &Pattern::modulation);
    visit("rhythm", &Pattern::rhythm);
    visit(numbers::kAttack, &Pattern::attack_s);
    visit(numbers::kRelease, &Pattern::release_s);
    visit(numbers::kDuration, &Pattern::duration_s);
    visit(ManyOf{"amplitude_curve", 0, limits::kMaxCurvePoints}, &Pattern::amplitude_curve);
    visit(ManyOf{"frequency_curve", 0, limits::kMaxCurvePoints}, &Pattern::frequency_curve);
    visit(ManyOf{"transients", 0, limits::kMaxTransients}, &Pattern::transients);
    visit("accents", OneOf{kAccents}, &Pattern::accents);
}

}  // namespace tact
