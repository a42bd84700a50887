// Sobol's sequence: points that fill a cube evenly, however many of them are taken.
//
// Source    Sobol' 1967; order of points Antonov & Saleev 1979; direction numbers of Joe & Kuo
//           2008 (new-joe-kuo-6, from 21,201 dimensions), the first 32 dimensions.
// Valid     dimensions 0 to kSobolDimensions - 1, points 0 to 2^32 - 1
// Exact     multiples of 2^-32: the same bits everywhere.
// Left out  scrambling; a shift of all points by the same bits keeps their evenness.
#pragma once

#include <cstddef>
#include <cstdint>

namespace tact {

inline constexpr std::size_t kSobolDimensions = 32;

// One coordinate of one point, in [0, 1); point 0 is the corner, without a shift. `shift` is added
// bit by bit, without carry.
double sobol_coordinate(std::uint32_t point, std::size_t dimension, std::uint32_t shift = 0);

}  // namespace tact
