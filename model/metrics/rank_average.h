// R8: several metrics made one by the mean of their ranks, the rule by which PM joins its parts.
//
// Of Msm, Mtm and OC it is the honest ablation of PM: the same fusion, and no physiology.
//
// Confidence  [H] ours, not from the paper
// Input     matrices of the same objects
// Output    mean of the ranks 1..m of each pair; depends on the set, as PM does
#pragma once

#include <span>

#include "model/dissimilarity/dissimilarity.h"

namespace tact {

Dissimilarity rank_average(std::span<const Dissimilarity> matrices);

}  // namespace tact
