// The parametric vibration as a value, and its waveform.
//
//     x(t) = A e(t) r(t) a(t) sum_j w_j sin(2 pi (f_j / f_1) F(t) + phi_j) + sum_k b_k(t - t_k)
//
// Carriers as the frequency curve drives them, times modulation e(t), rhythm gate with linear ramps
// r(t) and amplitude curve a(t), plus transients b_k in the phase of model/pattern/accents.h, or
// each at phase 0 where the pattern says that they are added. F(t) is the integral of the frequency
// curve, which is the first carrier's, times the pitch of the last note that began; f_1 t without
// curve and pitches. Read literally, Eq. 7's e(t) = sin(2 pi
// f_e t) is silent for f_e = 0; there the factor is 1.
//
// Source    Lim & Park 2023, Eq. 7, generalised.
// Left out  noise.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "model/common/units.h"
#include "model/pattern/curves.h"
#include "model/pattern/rhythm.h"
#include "model/signal/waveform.h"

namespace tact {

struct Carrier {
    double frequency_hz = 150.0;
    double weight = 1.0;
    double phase_rad = 0.0;

    bool operator==(const Carrier&) const = default;
};

enum class ModulationKind {
    product,  // sin(2 pi f t), 1 for f = 0: Eq. 7
    am        // 1 + depth sin(2 pi f t)
};

struct Modulation {
    ModulationKind kind = ModulationKind::product;
    double frequency_hz = 0.0;
    double depth = 1.0;  // of the am kind only

    bool operator==(const Modulation&) const = default;
};

// How transients meet what sounds under them. Added, their phase against it decides how strong the
// sum is: as everywhere before November 2026.
enum class Accents { joined, added };

struct Pattern {
    double amplitude_g = 1.0;
    std::vector<Carrier> carriers = std::vector<Carrier>(1);
    Modulation modulation;
    Rhythm rhythm;
    double attack_s = 0.0;
    double release_s = 0.0;
    double duration_s = 1.0;
    AmplitudeCurve amplitude_curve;     // empty: 1 throughout
    FrequencyCurve frequency_curve;     // empty: the first carrier's frequency throughout
    std::vector<Transient> transients;  // in any order; cut at the pattern's end
    Accents accents = Accents::joined;

    bool operator==(const Pattern&) const = default;
};

// What a person may choose. Panels clamp to these; files outside them are refused.
namespace limits {
inline constexpr Range kAmplitudeG{0.0, 50.0};
inline constexpr Range kCarrierHz{0.1, 1000.0};
inline constexpr Range kCarrierWeight{-10.0, 10.0};
inline constexpr Range kPhaseRad{-1000.0, 1000.0};
inline constexpr Range kModulationHz{0.0, 1000.0};
inline constexpr Range kDepth{0.0, 1.0};
inline constexpr Range kRhythmUnitS{0.001, 10.0};
inline constexpr Range kRampS{0.0, 10.0};
inline constexpr Range kDurationS{0.001, 60.0};
inline constexpr Range kScaleG{1e-6, 1e6};
inline constexpr std::size_t kMaxCarriers = 8;
inline constexpr std::size_t kMaxPatterns = 10'000;
}  // namespace limits

// The pattern with every number moved to the nearest one in range, and what was drawn as
// with_duration() leaves it: without fault (model/pattern/drawn_fault.h).
Pattern clamped(Pattern pattern);

// The pattern as long as that. What was drawn stays where it is: longer, curves are held; shorter,
// they are cut at the new end, and transients that begin behind it are gone.
Pattern with_duration(Pattern pattern, double duration_s);

// Whether a transient begins, ends or has its middle where carriers sound.
bool has_accents(const Pattern& pattern);

// Whether it has a curve or a transient.
bool is_drawn(const Pattern& pattern);

// At a time: the amplitude curve's factor; the first carrier's frequency; and A r(t) a(t), what
// the carriers are scaled by, without their modulation and without transients. 0 g outside of the
// pattern.
double amplitude_factor(const Pattern& pattern, double t_s);
double first_carrier_hz(const Pattern& pattern, double t_s);
double envelope_g(const Pattern& pattern, double t_s);

// The first carrier's frequency over time: the frequency curve times the pitches of the notes, each
// point within the limits of a carrier. Empty where neither is there.
FrequencyCurve sounding_frequency(const Pattern& pattern);

// The same vibration with its pitches in the frequency curve.
Pattern with_drawn_pitches(Pattern pattern);

// The same vibration with its curves as notes: where they are flat between jumps that lie on one
// grid of 1 ms or more. None elsewhere, where there are notes already, for one note throughout, and
// for more kinds of notes than there are letters. Where the frequency goes between two notes, what
// sounds next begins at another phase.
std::optional<Pattern> with_found_notes(const Pattern& pattern);

// Samples x[n] = x(n / rate_hz), n = 0 .. round(duration_s rate_hz) - 1. A carrier that its ratio
// to the first one takes above half the rate is silent there.
Waveform render(const Pattern& pattern, double rate_hz = kModelRateHz);

// The same without its transients.
Waveform render_carriers(const Pattern& pattern, double rate_hz = kModelRateHz);

}  // namespace tact
