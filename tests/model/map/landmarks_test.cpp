#include "model/map/landmarks.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "model/map/mds.h"

namespace landmarks_test {

using namespace tact;

namespace {

Dissimilarity distances_of(const Eigen::MatrixXd& points) {
    Dissimilarity all;
    all.size = static_cast<std::size_t>(points.rows());
    for (Eigen::Index i = 0; i < points.rows(); ++i) {
        for (Eigen::Index j = i + 1; j < points.rows(); ++j) {
            all.condensed.push_back((points.row(i) - points.row(j)).norm());
        }
    }
    return all;
}

// The largest difference between distances of the two maps, over the largest distance.
double misfit(const Eigen::MatrixXd& points, const Dissimilarity& wanted) {
    const Dissimilarity found = distances_of(points);
    double worst = 0.0;
    double largest = 0.0;
    for (std::size_t k = 0; k < wanted.condensed.size(); ++k) {
        worst = std::max(worst, std::abs(found.condensed[k] - wanted.condensed[k]));
        largest = std::max(largest, wanted.condensed[k]);
    }
    return worst / largest;
}

}  // namespace

TEST_CASE("landmarks: distances in space give the points back, by a few of them") {
    for (const double unit : {1.0, 1e150}) {
        const Eigen::MatrixXd points = unit * random_start(90, 3, 1, 1);
        const Dissimilarity all = distances_of(points);
        CHECK(misfit(landmark_scaling(all, 3, 12), all) < 1e-9);
        CHECK(misfit(landmark_scaling(all, 2, 12), all) > 0.01);  // an axis is missing
    }
}

TEST_CASE("landmarks: of no more objects than landmarks the map is Torgerson's") {
    const Dissimilarity all = distances_of(random_start(40, 3, 2, 1));
    CHECK(landmark_scaling(all, 3, 40) == torgerson(all, 3));
}

TEST_CASE("landmarks: equal, missing and lone dissimilarities give finite points") {
    Dissimilarity all = distances_of(random_start(30, 3, 3, 1));
    all.condensed[5] = std::numeric_limits<double>::quiet_NaN();
    CHECK(landmark_scaling(all, 3, 10).allFinite());
    std::ranges::fill(all.condensed, 0.0);
    CHECK(landmark_scaling(all, 3, 10).isZero());
    std::ranges::fill(all.condensed, 2.0);
    CHECK(landmark_scaling(all, 3, 10).allFinite());
}

}  // namespace landmarks_test
