// The waveforms of a set (pattern_set.h), rendered by many threads.
#pragma once

#include <vector>

#include "model/set/pattern_set.h"

namespace tact {

// Each at its own length, which is what PM and every metric take. One clip of a minute does not
// make all others a minute long. threads = 0: all cores.
std::vector<Waveform> own_waveforms(const PatternSet& set, int threads = 0);

}  // namespace tact
