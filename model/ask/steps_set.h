// Even steps as patterns of a set: their names, and what is said of each.
#pragma once

#include <vector>

#include "model/ask/steps.h"
#include "model/set/pattern_set.h"

namespace tact {

// What lies between two vibrations of a set, and the end behind it where that is not one of them:
// "A to B 2", "A to B 3" .. under names that are free.
std::vector<Vibration> vibrations_between(const PatternSet& set, std::size_t from, std::size_t to,
                                          const EvenSteps& steps);

// A set of these alone, the ends among them, with the model of the first.
PatternSet set_of_steps(const PatternSet& set, std::size_t from, std::size_t to,
                        const EvenSteps& steps);

}  // namespace tact
