// What drawing a matrix and placing it have in common. Private to the matrix view.
#pragma once

#include <string>

#include "viz/charts/matrix_view.h"

namespace tact {

// The darkest value.
double largest_of(const MatrixScene& scene);

// Ranks that are all the same say nothing about any pair; a value of zero does.
bool is_flat(const MatrixScene& scene);

// A value as people read it: what is next to nothing beside the largest is rounding, and as a
// number of fourteen zeros wider than its cell.
std::string value_text(double value, double largest);

// More patterns have numbers only in the rows and columns of the selected ones.
inline constexpr std::size_t kMostWithAllValues = 10;

// In its cell: of many, which are small, two digits.
std::string cell_text(const MatrixScene& scene, double value, double largest);

}  // namespace tact
