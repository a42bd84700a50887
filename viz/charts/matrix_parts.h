// What drawing a matrix and placing it have in common. Private to the matrix view.
#pragma once

#include <string>

#include "viz/charts/matrix_view.h"

namespace tact {

// The brightest value.
double largest_of(const MatrixScene& scene);

// Ranks that are all the same say nothing about any pair; a value of zero does.
bool is_flat(const MatrixScene& scene);

// A value as people read it: what is next to nothing beside the largest is rounding, and as a
// number of fourteen zeros wider than its cell.
std::string value_text(double value, double largest);

}  // namespace tact
