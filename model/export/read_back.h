// Patterns as they come back from exported files.
#pragma once

#include <string_view>

#include "model/common/expected.h"
#include "model/io/effects/effect.h"
#include "model/io/effects_out/write_effect.h"
#include "model/io/recordings/recording.h"

namespace tact {

// The C initialiser of a parametric vibration of OpenXR, as model/io/effects_out writes it, read
// back.
//
// Left out  initialisers that others wrote: their names and their order are not looked at.

// Straight from minFrequencyHz to maxFrequencyHz, whatever law the map has.
Expected<Effect> openxr_back(std::string_view text, const EffectFile& file);

// Samples as they were written, read back at the model's rate.
//
// Output    CSV: the table's numbers at the rate that they were written at; nothing is taken off,
//           as a reader of accelerometers would

Expected<Recording> samples_back(TargetFormat format, const WrittenEffect& written,
                                 const EffectTarget& target);

}  // namespace tact
