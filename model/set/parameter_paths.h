// Patterns that differ in one number alone, joined in its order: what a map shows of a parameter.
//
// Input     vibrations; recordings and layers are in no path
// Output    places of two and more, the number rising
// Exact     same input, same paths.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "model/pattern/pattern_parameter.h"
#include "model/set/pattern_set.h"

namespace tact {

std::optional<double> value_of(const Vibration& vibration, PatternParameter parameter);

std::vector<std::vector<std::size_t>> paths_along(std::span<const Vibration> vibrations,
                                                  PatternParameter parameter);

// The number whose paths join the most patterns; none where no two differ in one alone.
std::optional<PatternParameter> most_joining(std::span<const Vibration> vibrations);

}  // namespace tact
