// The C initialiser of a parametric vibration of OpenXR, as model/io/effects_out writes it, read
// back.
//
// Left out  initialisers that others wrote: their names and their order are not looked at.
#pragma once

#include <string_view>

#include "model/io/effects/effect.h"

namespace tact {

// Straight from minFrequencyHz to maxFrequencyHz, whatever law the map has.
Expected<Effect> openxr_back(std::string_view text, const EffectFile& file);

}  // namespace tact
