// Stress of dissimilarities without any structure: what a map's stress has to be compared with.
//
// Source    Klahr 1969; Spence & Ogilvie 1973. Every draw is a random order of the pairs.
// Output    stress-1 of the best map of each draw
// Valid     for primary ties and complete matrices. Where n is not well above 2k + 1, random orders
//           fit as well: stress then says nothing about the patterns.
// Exact     same input, same bits, on any number of threads.
#pragma once

#include <cstddef>
#include <cstdint>

#include "model/common/distributions.h"

namespace tact {

struct RandomStress {
    double mean = 0.0;
    Interval middle;  // from the 5 % to the 95 % quantile
};

struct RandomStressParams {
    std::size_t draws = 100;
    int random_starts = 10;  // of every draw, besides Torgerson's
    std::uint64_t seed = 4;
    int threads = 0;  // 0: all cores
};

// For n objects in k dimensions; zeros for n <= k + 1, where any order fits. Takes 0.1 s for a
// dozen objects and seconds for fifty: keep it with n, k and the parameters.
RandomStress random_stress(std::size_t objects, int dimensions,
                           const RandomStressParams& params = {});

}  // namespace tact
