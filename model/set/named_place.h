// Vibrations of a set by the name that a person gives.
//
// Output    a position, or a sentence that names some that there are
#pragma once

#include <string>

#include "model/common/expected.h"
#include "model/set/pattern_set.h"

namespace tact {

Expected<std::size_t> place_of(const PatternSet& set, const std::string& name);

// The same of a pattern made of parameters: a recording and layers are refused.
Expected<std::size_t> pattern_place_of(const PatternSet& set, const std::string& name);

// The pattern itself, or null: no vibration has that name, or it is no such pattern.
const Pattern* pattern_named(const PatternSet& set, const std::string& name);

}  // namespace tact
