// Where values would stand among others that have ranks already.
//
// A value between two of the others stands halfway between their ranks, one below all at 1/2, one
// above all half behind the last. The others themselves get their average ranks, to the bit: so a
// loss is told in the ranks, and in the PM, that people know of the intended set. Ranks among
// themselves would not do: their sum never changes, whatever was lost.
//
// Source    ours; rounding and ties as in model/dissimilarity/dissimilarity.h
#pragma once

#include <span>
#include <vector>

namespace tact {

// `others` may be empty: all stand at 1/2.
std::vector<double> ranks_among(std::span<const double> values, std::span<const double> others);

}  // namespace tact
