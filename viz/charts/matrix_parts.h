// Helpers shared by drawing a matrix and its layout. Private to the matrix view.
#pragma once

#include <string>

#include "viz/charts/matrix_view.h"

namespace tact {

// The value with the darkest colour.
double largest_of(const MatrixScene& scene);

// Whether all values are equal and not zero: such ranks say nothing about any pair.
bool is_flat(const MatrixScene& scene);

// A value as text; a value negligible beside the largest is a rounding error, and printed as 0.
std::string value_text(double value, double largest);

// With more patterns, only the rows and columns of the selected ones have numbers.
inline constexpr std::size_t kMostWithAllValues = 10;

// The text of a cell: two digits if there are many patterns, whose cells are small.
std::string cell_text(const MatrixScene& scene, double value, double largest);

}  // namespace tact
