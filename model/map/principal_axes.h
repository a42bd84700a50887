// One frame for a map whose turn, mirror image and place have no meaning.
//
// Source    Pearson 1901.
// Input     n x k coordinates
// Output    the same shape, centred, axes in the order of falling variance
// Exact     same input, same bits. Axes of equal variance, which could be turned at will, are laid
//           through the first objects, so that the result does not hang on rounding.
#pragma once

#include <Eigen/Core>

namespace tact {

Eigen::MatrixXd on_principal_axes(const Eigen::MatrixXd& points);

// Mirrors every column whose largest coordinate is negative; of equally large ones (to 1e-9) the
// first object's decides.
void mirror_to_positive(Eigen::MatrixXd& points);

}  // namespace tact
