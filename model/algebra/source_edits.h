// The edits of the algebra, of anything: patterns, recordings and layers.
//
// A recording is edited as samples: reversed, repeated, joined, trimmed below 1 % of its peak,
// faded, normalised. Layers are edited each where that is what the whole would be. Mixed is what
// can be one pattern as one, all else as layers.
//
// Source    ours
// Output    a recording that was edited has no file, and measures no pattern any more; or one
//           sentence: "trim: expected ..."
// Left out  what would change the frequency of a recording; edits of the layers' sum: fades, trims,
//           repetitions. Layers can be edited one by one.
#pragma once

#include <span>

#include "model/algebra/algebra.h"
#include "model/set/pattern_set.h"

namespace tact {

// In their order, of a vibration whose name the first of new layers takes.
Expected<VibrationSource> edited_source(const Vibration& vibration, std::span<const Edit> edits,
                                        const PhysiologyTables& tables);

}  // namespace tact
