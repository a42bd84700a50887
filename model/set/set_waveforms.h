// The waveforms of a set (pattern_set.h), rendered by many threads.
#pragma once

#include <vector>

#include "model/set/pattern_set.h"

namespace tact {

// threads = 0: all cores.
std::vector<Waveform> model_waveforms(const PatternSet& set, int threads);

}  // namespace tact
