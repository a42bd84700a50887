// A set of vibrations and the subset picked from it.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "model/set/pattern_set.h"
#include "model/subset/subset.h"

namespace tact {

// The problem of picking `count`: locked vibrations are kept and dropped ones left out. Vibrations
// that nobody feels (`unfelt`, places in the set) are left out too unless they are locked, as
// nobody could tell them from nothing.
SubsetProblem subset_problem(const PatternSet& set, std::size_t count, SubsetObjective objective,
                             std::span<const std::size_t> unfelt = {});

// Those of them that are left out only because nobody feels them.
std::vector<std::size_t> left_out_unfelt(const PatternSet& set,
                                         std::span<const std::size_t> unfelt);
std::string left_out_words(std::size_t count);  // "1 not felt pattern left out"; empty: none is

// `wanted`, or as near to it as locks allow: for who has not said how many.
std::size_t possible_count(const SubsetProblem& problem, std::size_t objects, std::size_t wanted);

// The set of these vibrations alone, in the given order, with what people said of them.
PatternSet part_of(const PatternSet& set, std::span<const std::size_t> members);

}  // namespace tact
