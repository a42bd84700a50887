// Dissimilarities as whole numbers, so that sums are exact in any order and ties are ties.
//
// Input     a dissimilarity matrix; what is not a number or infinite (not rated) counts as 0:
// nobody
//           vouches for such a pair
// Output    multiples of a power of two, 34 bits for the largest: 6e-11 of it are lost
// Exact     ranks, also averaged and halved ones, of up to 10,000 objects.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "model/dissimilarity/dissimilarity.h"

namespace tact {

using Units = std::int64_t;

struct WholeDistances {
    std::size_t size = 0;
    int exponent = 0;           // a unit is 2^exponent
    Units divisor = 1;          // of all values: sums are multiples of it
    std::vector<Units> square;  // n x n, row by row, 0 on the diagonal

    Units operator()(std::size_t i, std::size_t j) const { return square[i * size + j]; }
    const Units* row(std::size_t i) const { return square.data() + i * size; }

    bool operator==(const WholeDistances&) const = default;
};

// The same for floating-point work, which is exact in single values.
Eigen::MatrixXd real_distances(const WholeDistances& distances);

WholeDistances whole_distances(const Dissimilarity& dissimilarity);

// Each value that some pair has, once, ascending.
std::vector<Units> distinct_values(const WholeDistances& distances);

// No sum of `pairs` values that comes to `units` units is larger than this.
double largest_meant(const WholeDistances& distances, Units units, std::size_t pairs);

}  // namespace tact
