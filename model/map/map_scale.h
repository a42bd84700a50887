// How long one of a dissimilarity is in a map: the slope of distances over dissimilarities, through
// 0, by least squares.
//
// Input     places, n x d; n objects' dissimilarities; pairs with either not finite are left out
// Output    a length of the map; 0 if there is no such pair, and if n differs
// Valid     roughly for a non-metric map, which holds to the order of dissimilarities alone
#pragma once

#include <Eigen/Core>

#include "model/dissimilarity/dissimilarity.h"

namespace tact {

double length_of_one(const Eigen::MatrixXd& places, const Dissimilarity& dissimilarity);

}  // namespace tact
