// Alienation: how far two maps of the same objects are from being one shape.
//
// Source    Borg & Leutner 1985; Guttman 1968. K = sqrt(1 - c^2), c the congruence of distances,
//           sum d(X) d(Y) / sqrt(sum d(X)^2 sum d(Y)^2), not centred.
// Input     coordinates, one row an object; the maps may differ in their number of columns
// Output    0: one shape, whatever the turn, mirror image, place and size
// Valid     compressed: unrelated maps of three dimensions have K of about .5, not 1. Read it
// beside
//           its chance level.
// Exact     same input, same bits, on any number of threads.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <span>

#include "model/common/distributions.h"
#include "model/common/expected.h"
#include "model/dissimilarity/permutation.h"

namespace tact {

// K of the distances. Errors: fewer than three points, other numbers of points, all points of a map
// on one spot, coordinates that are not finite.
Expected<double> alienation(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b);

// Another measure under the same letter: sqrt(1 - r^2), r the correlation after Procrustes
// alignment. Larger: .8 to .9 for unrelated maps. Errors as above.
Expected<double> alienation_procrustes(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b);

// PROTEST, one-sided: how often the points of `b` under other names fit `a` at least as well after
// Procrustes alignment. Source: Jackson 1995. Errors as above.
Expected<PermutationTest> protest(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b,
                                  const PermutationParams& params);

// A third one, of a single map: sqrt(1 - mu^2), mu the congruence of its distances with their
// disparities: the stress of the best size. Pairs of a NaN disparity are left out; 0 of none.
double alienation_of_fit(std::span<const double> distances, std::span<const double> disparities);

// K of unrelated maps: Gaussian points, n in k dimensions each.
struct AlienationChance {
    double mean = 0.0;
    Interval middle;  // from the 5 % to the 95 % quantile
};

struct AlienationChanceParams {
    std::size_t draws = 10'000;
    std::uint64_t seed = 3;
    int threads = 0;  // 0: all cores
};

// Zeros for fewer than three points.
AlienationChance chance_alienation(std::size_t points, int dimensions,
                                   const AlienationChanceParams& params = {});

// 1 - K / K_chance: 1 for one shape, 0 for no better than unrelated maps, less for worse.
double corrected_alienation(double alienation, const AlienationChance& chance);

// One-sided: how often the points of `b` under other names are at least as close to `a` in shape.
// Errors as of alienation.
Expected<PermutationTest> alienation_test(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b,
                                          const PermutationParams& params);

}  // namespace tact
