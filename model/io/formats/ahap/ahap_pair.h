// Two AHAP files that are one pattern: what is continuous in one, transients in the other, so that
// no control of the continuous part reaches the transients.
//
// The rule: in one folder NAME_continuous.ahap and NAME_transients.ahap, whose Metadata name the
// same "Project" or none, and of which the second has nothing continuous that is felt. So Meta's
// converter and our writer name them.
//
// Source    the Haptics SDK of Meta (MIT): its converter's names
// Left out  pairs in two folders.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "model/io/effects/effect_format.h"

namespace tact {

inline constexpr const char* kContinuousEnding = "_continuous.ahap";
inline constexpr const char* kTransientsEnding = "_transients.ahap";

// "buzz_transients.ahap" of "buzz_continuous.ahap"; none: it is not the name of a first one.
std::optional<std::string> second_of_pair(std::string_view path);

// Both as one effect, "buzz"; none: by the rule they are two.
std::optional<EffectsRead> joined_pair(const EffectsRead& continuous,
                                       const EffectsRead& transients);

}  // namespace tact
