// Classical scaling of very many objects by some of them: a start for a map that cannot wait for
// Torgerson's, whose time grows with the third power of their number.
//
// Source    de Silva & Tenenbaum 2004, landmark MDS
// Input     a dissimilarity matrix; NaN pairs count as the mean of the others
// Output    n x k coordinates about the centre of the landmarks; zeros in the columns of vanished
//           eigenvalues
// Exact     Torgerson's coordinates up to a motion, where the dissimilarities are distances in k
//           dimensions, and always where there are no more objects than landmarks
#pragma once

#include <Eigen/Core>
#include <cstddef>

#include "model/dissimilarity/dissimilarity.h"

namespace tact {

inline constexpr std::size_t kLandmarks = 200;

Eigen::MatrixXd landmark_scaling(const Dissimilarity& dissimilarity, int dimensions,
                                 std::size_t landmarks = kLandmarks);

}  // namespace tact
