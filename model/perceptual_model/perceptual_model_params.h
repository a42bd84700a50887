// Everything a researcher may choose in the perceptual model: neural coding, the rhythm envelope,
// and the six trained weights that join them.
//
// Source    Lim & Park 2023, sections 3-5; choices marked [ours] are argued in the comments.
#pragma once

#include "model/common/units.h"
#include "model/physiology/neural_coding_params.h"

namespace tact {

enum class EnvelopeScale {
    normalised,  // [ours] to its own maximum: rhythm, not amplitude
    raw          // g
};

enum class EnvelopeAlignment {
    causal,  // [ours] mean of the last 10 ms
    centred
};

// Panels clamp to this; files outside it are refused.
namespace limits {
inline constexpr Range kWeight{0.0, 1000.0};
inline constexpr Range kWaitingCost{0.0, 100.0};  // above the envelopes' reach none pays to wait
}  // namespace limits

struct EnvelopeParams {
    EnvelopeScale scale = EnvelopeScale::normalised;
    EnvelopeAlignment alignment = EnvelopeAlignment::causal;
    // What a sample costs at which one envelope waits for the other, in the envelope's unit. Free
    // in the paper; so how long a note lasts counts nearly nothing.
    double waiting_cost = 0.0;

    bool operator==(const EnvelopeParams&) const = default;
};

struct PerceptualModelParams {
    NeuralCodingParams coding;
    EnvelopeParams envelope;
    PerReceptor<double> channel_weight{0.2, 0.7, 0.0, 0.5};  // trained
    double nc_weight = 0.5;                                  // trained
    double oc_weight = 0.5;                                  // trained

    bool operator==(const PerceptualModelParams&) const = default;
};

}  // namespace tact
