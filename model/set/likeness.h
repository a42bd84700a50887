// Roughly how alike vibrations are, before any model has compared them: for pictures that wait.
//
// Strength in 24 parts of the longest one's time, as a share of the set's strongest, and the mean
// frequency in octaves. What is made of parameters is not rendered.
//
// Source    ours
// Left out  all that makes vibrations feel alike: PM says that
// Exact     same set, same order
#pragma once

#include <cstddef>
#include <vector>

#include "model/set/pattern_set.h"

namespace tact {

// Places in the set in an order in which each is followed by the one most like it of those that
// are left, the first one first. Above 1,000, the order of the set.
std::vector<std::size_t> order_by_likeness(const PatternSet& set);

}  // namespace tact
