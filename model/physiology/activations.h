// How the receptors of all types are driven, the logarithms of the components taken once.
//
// Exact     the bits of the types one by one (activation.h).
#pragma once

#include <vector>

#include "model/physiology/activation.h"

namespace tact {

PerReceptor<Activation> activations(const std::vector<Component>& components,
                                    const NeuralCodingParams& params);

}  // namespace tact
