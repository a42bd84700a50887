// Samples as they were written, read back at the model's rate.
//
// Output    CSV: the table's numbers at the rate that they were written at; nothing is taken off,
// as
//           a reader of accelerometers would
#pragma once

#include "model/common/expected.h"
#include "model/io/effects_out/write_effect.h"
#include "model/io/recordings/recording.h"

namespace tact {

Expected<Recording> samples_back(TargetFormat format, const WrittenEffect& written,
                                 const EffectTarget& target);

}  // namespace tact
