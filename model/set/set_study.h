// What a study takes from a set: which patterns, and a fingerprint of what is felt.
#pragma once

#include <string>
#include <vector>

#include "model/set/pattern_set.h"

namespace tact {

// Fingerprint of the names and waveforms of the patterns that take part, as 16 hexadecimal digits.
// Another amplitude is another study.
std::string study_fingerprint(const PatternSet& set, const std::vector<std::string>& names);

// Names of the patterns that take part, in the order of the set; those that are gone are left out.
std::vector<std::string> study_patterns(const PatternSet& set);

}  // namespace tact
