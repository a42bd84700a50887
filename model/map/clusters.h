// Groups of objects that are close to each other, by average linkage.
//
// Source    Sokal & Michener 1958 (UPGMA); nearest-neighbour chains: Murtagh 1983.
// Input     dissimilarities; what is not finite counts as the largest there is
// Output    a group for each object; 0, 1, .. in the order of their first objects
// Exact     of ties the pair with the lowest indices is joined first.
#pragma once

#include <cstddef>
#include <vector>

#include "model/dissimilarity/dissimilarity.h"

namespace tact {

// `count` groups, or as many as there are objects.
std::vector<std::size_t> clusters(const Dissimilarity& dissimilarity, std::size_t count);

// The order of the leaves of that tree: alike ones beside each other; of two branches the one with
// the first object is first.
std::vector<std::size_t> clustered_order(const Dissimilarity& dissimilarity);

}  // namespace tact
