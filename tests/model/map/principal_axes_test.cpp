#include "model/map/principal_axes.h"

#include <doctest/doctest.h>

#include <Eigen/QR>
#include <cmath>

#include "tests/support/made_up_maps.h"

namespace principal_axes_test {

using namespace tact;
using Eigen::MatrixXd;

namespace {

// A rotation, for every other seed with a reflection.
MatrixXd random_turn(Eigen::Index k, std::uint32_t seed) {
    MatrixXd turn = Eigen::HouseholderQR<MatrixXd>(random_map(k, k, seed)).householderQ();
    if (seed % 2 == 0) turn.col(0) = -turn.col(0);
    return turn;
}

// Whatever way it is turned, mirrored and shifted, a map has one frame.
void check_one_frame(const MatrixXd& map) {
    const MatrixXd frame = on_principal_axes(map);
    for (std::uint32_t seed = 1; seed <= 20; ++seed) {
        const MatrixXd moved = (map * random_turn(map.cols(), seed)).rowwise() +
                               random_map(1, map.cols(), seed + 100).row(0);
        // Variances differ by 1e-2 and more here, so axes move by rounding / 1e-2.
        CHECK((on_principal_axes(moved) - frame).cwiseAbs().maxCoeff() <= 1e-12);
    }
}

}  // namespace

TEST_CASE("principal axes: one frame for all turns, mirror images and places of a map") {
    check_one_frame(random_map(12, 3, 1));
    check_one_frame(random_map(9, 2, 2));
}

TEST_CASE("principal axes: one frame also where no axis stands out") {
    MatrixXd square(4, 2);
    square << 1, 1, 1, -1, -1, -1, -1, 1;
    check_one_frame(square);
    MatrixXd tetrahedron(4, 3);
    tetrahedron << 1, 1, 1, 1, -1, -1, -1, 1, -1, -1, -1, 1;
    check_one_frame(tetrahedron);
    MatrixXd prism(8, 3);  // square in two axes, long in the third
    prism << square, 3 * MatrixXd::Ones(4, 1), square, -3 * MatrixXd::Ones(4, 1);
    check_one_frame(prism);
}

TEST_CASE("principal axes: centred, uncorrelated, in the order of variance, distances kept") {
    const MatrixXd map = random_map(12, 3, 3);
    const MatrixXd frame = on_principal_axes(map);
    CHECK(frame.colwise().mean().cwiseAbs().maxCoeff() <= 1e-15);
    const MatrixXd products = frame.transpose() * frame;
    CHECK(std::abs(products(0, 1)) + std::abs(products(0, 2)) + std::abs(products(1, 2)) <= 1e-13);
    CHECK(products(0, 0) > products(1, 1));
    CHECK(products(1, 1) > products(2, 2));
    for (Eigen::Index i = 1; i < 12; ++i) {
        const double before = (map.row(i) - map.row(0)).norm();
        CHECK(std::abs((frame.row(i) - frame.row(0)).norm() - before) <= 1e-14);
    }
}

TEST_CASE("principal axes: the largest coordinate of an axis is positive") {
    const MatrixXd frame = on_principal_axes(random_map(12, 3, 4));
    for (Eigen::Index c = 0; c < 3; ++c) {
        CHECK(frame.col(c).maxCoeff() == frame.col(c).cwiseAbs().maxCoeff());
    }
}

TEST_CASE("principal axes: a flat map has an empty third axis") {
    MatrixXd flat(6, 3);
    flat << random_map(6, 2, 5), MatrixXd::Zero(6, 1);
    const MatrixXd frame = on_principal_axes(flat * random_turn(3, 6));
    CHECK(frame.col(2).isZero(0.0));
    CHECK(frame.col(1).norm() > 0.1);
}

TEST_CASE("principal axes: one point, or all on one spot, is the origin") {
    CHECK(on_principal_axes(random_map(1, 3, 7)).isZero(0.0));
    CHECK(on_principal_axes(MatrixXd::Constant(5, 3, 2.0)).isZero(0.0));
    CHECK(on_principal_axes(MatrixXd(0, 3)).rows() == 0);
}

}  // namespace principal_axes_test
