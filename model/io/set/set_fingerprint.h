// Numbers that tell whether a set is computed from what it was computed from before: what a person
// chose, not what arithmetic made of it.
//
// Left out  names, notes, colours: no number depends on them.
#pragma once

#include <cstdint>

#include "model/set/pattern_set.h"

namespace tact {

// Changes with any parameter of a pattern, any sample of a recording, and their order.
std::uint64_t vibrations_fingerprint(const PatternSet& set);

// Changes with any parameter of the model that is not at its default.
std::uint64_t model_fingerprint(const PatternSet& set);

}  // namespace tact
