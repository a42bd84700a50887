// How much of a map one number of its patterns explains: of the variance of the places, the share
// that a straight line through them along the number has.
//
// Input     places, n x d; a value for each; rows with either not finite are left out
// Output    0 to 1; 0 of fewer than three rows, of equal values and of places that fell together
// Source    multivariate R squared of a regression on one variable
// Left out  bent ways, such as a ring: they are explained in part
#pragma once

#include <Eigen/Core>
#include <span>

namespace tact {

double explained_share(const Eigen::MatrixXd& places, std::span<const double> values);

}  // namespace tact
