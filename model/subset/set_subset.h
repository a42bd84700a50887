// A set of vibrations and the subset picked from it.
#pragma once

#include <cstddef>
#include <span>

#include "model/set/pattern_set.h"
#include "model/subset/subset.h"

namespace tact {

// To pick `count`: locked vibrations are kept, dropped ones left out.
SubsetProblem subset_problem(const PatternSet& set, std::size_t count, SubsetObjective objective);

// The set of these vibrations alone, in the given order, with what people said of them.
PatternSet part_of(const PatternSet& set, std::span<const std::size_t> members);

}  // namespace tact
