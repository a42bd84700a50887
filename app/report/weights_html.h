// Star plots of what each participant goes by: a ray a dimension of the common map, as long as its
// weight, and of all of them on average as a dashed line.
#pragma once

#include <string>

#include "model/evaluation/individual_weights.h"

namespace tact {

// A section of a page; empty where nobody has weights.
std::string weights_section(const IndividualWeights& weights);

// Its CSS.
std::string weights_style();

}  // namespace tact
