// A good subset soon, which the exact search then has to beat.
//
// Source    farthest-first: Gonzalez 1985 (a 2-approximation for metrics only, which ranks are
//           not); then single exchanges while they help.
// Exact     same distances, same subset.
// Left out  tabu search and path relinking: the exact search does the rest.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "model/subset/whole_distances.h"

namespace tact {

enum class SubsetObjective {
    max_min,  // the weakest pair as far apart as can be; ties by sum, then lowest indices
    max_sum   // the sum of all pairs as large as can be; ties by lowest indices
};

// `kept` and count - kept.size() of the others; sorted. None where there are too few.
std::vector<std::size_t> started_subset(const WholeDistances& distances, SubsetObjective objective,
                                        std::size_t count, std::span<const std::size_t> kept,
                                        std::span<const std::size_t> others);

// The smallest distance within; of fewer than two members the largest number there is.
Units weakest_of(const WholeDistances& distances, std::span<const std::size_t> members);

}  // namespace tact
