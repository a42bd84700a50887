// How strongly a vibration drives one receptor type, and up to which distance from the probe.
//
// Mean rate at the centre over the components above threshold, S: f0 = sum_S alpha_k (log10 v_k -
// beta_k),   A = sum_S alpha_k
// A wave falls with distance as V(r) = v (1.5 mm / r)^2 beyond the hot zone, so each log10 v_k
// falls by 2 log10(r / 1.5) and the rate by 2 A log10(r / 1.5). It is zero at r_max = 1.5 mm 10^(f0
// / (2 A)),
// or at the end of the fingertip, if that comes first: there are no receptors farther out.
//
// Source    Lim & Park 2023, Eqs. 1-3; Johnson 1974 (hot zone).
// Input     amplitude spectrum of the mean-removed, padded signal
// Valid     components of 1-500 Hz
// Left out  plateaus, adaptation; S is fixed at the centre.
#pragma once

#include "model/physiology/mechanoreceptor.h"
#include "model/physiology/neural_coding_params.h"
#include "model/signal/spectrum.h"

namespace tact {

inline constexpr double kProbeRadiusMm = 0.5;
inline constexpr double kHotZoneMm = 1.5;  // 1 mm beyond the probe's edge: rate as at the centre
// [ours] The largest distance of a receptor from the probe: from its last crease to its end, the
// pad of an index finger is about 25 mm long and less than 20 mm wide (Greiner 1991, Hand
// Anthropometry of U.S. Army Personnel), and the model's skin is flat and without joints. Without
// this limit, r_max is metres for a strong vibration of a few Hz, with millions of receptors that
// no finger has. The bundled sets reach 15 mm, so it does not change them.
inline constexpr double kFingertipMm = 25.0;

inline constexpr double kLowestComponentHz = 1.0;
inline constexpr double kHighestComponentHz = 500.0;
inline constexpr double kFaintestComponentG = 1e-9;

struct Component {
    double frequency_hz = 0.0;
    double amplitude_g = 0.0;  // peak
    double skin_um = 0.0;      // the amplitude in the logarithm of Eq. 2: peak displacement by
                               // default

    bool operator==(const Component&) const = default;
};

// The spectral components that can drive receptors, by ascending frequency.
std::vector<Component> components(const Spectrum& spectrum, const NeuralCodingParams& params);

struct Activation {
    double rate_hz = 0.0;    // f0, impulses/s at the centre
    double slope_sum = 0.0;  // A, impulses/s per log10
    double radius_mm = 0.0;  // r_max, at most kFingertipMm; 0: no receptor fires

    bool operator==(const Activation&) const = default;
};

// The activation of all receptor types.
PerReceptor<Activation> activations(const std::vector<Component>& components,
                                    const NeuralCodingParams& params);

// Mean rate at a distance from the centre, impulses/s.
double rate_at_hz(const Activation& activation, double distance_mm);

}  // namespace tact
