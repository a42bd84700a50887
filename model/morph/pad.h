// A pattern among up to four: the corners of a square, and a place in it.
//
// Source    ours: model/morph, first along the upper and the lower edge, then between the two
// Input     corners upper left, upper right, lower left, lower right, of which the last or the last
//           two may be missing: then the lower edge is its left corner, or the same as the upper
// Output    at a corner that pattern itself, bit for bit
// Left out  what morph_jumps() names, which changes at half of the way; rhythms of four corners are
//           warped along the edges alone: between the edges their drawn notes fade
#pragma once

#include <vector>

#include "model/pattern/pattern.h"

namespace tact {

inline constexpr std::size_t kMostCorners = 4;

// `right` and `down` from the upper left corner, 0 to 1. At least one corner.
Pattern mixed_among(const std::vector<Pattern>& corners, double right, double down);

}  // namespace tact
