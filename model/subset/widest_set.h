// The set of k objects whose weakest pair is as far apart as can be: max-min dispersion, exactly.
//
// Source    a threshold search over the distinct distances, each a clique question
//           (model/subset/clique.h): Sayah & Irnich 2017.
// Exact     same input, same distance; which of several sets has it is settled elsewhere.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "model/subset/search_limit.h"
#include "model/subset/whole_distances.h"

namespace tact {

struct WidestProblem {
    const WholeDistances& distances;
    std::size_t count = 0;                // k
    std::span<const std::size_t> kept;    // in the set; not among `others`
    std::span<const std::size_t> others;  // to choose from
};

struct WidestSet {
    std::vector<std::size_t> members;  // ascending
    Units weakest = 0;
    Units bound = 0;  // no set has a weakest pair above it; equal to `weakest` where proven
};

// What is told at first and after each question: how much is done, 0..1, and what is found by now,
// its members in no order.
using WidestTold = std::function<void(double share, const WidestSet& now)>;

// Begins with `start`, a set of the problem. `bound`: known already.
WidestSet widest_set(const WidestProblem& problem, std::vector<std::size_t> start,
                     std::optional<Units> bound, const SearchLimit& limit,
                     const WidestTold& told = {});

// Those of `others` that are at least so far from all that are kept.
std::vector<std::size_t> far_from_kept(const WidestProblem& problem, Units least);

}  // namespace tact
