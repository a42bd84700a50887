#include "model/map/procrustes.h"

#include <doctest/doctest.h>

#include <Eigen/LU>
#include <Eigen/QR>
#include <cmath>

#include "tests/support/made_up_maps.h"

namespace procrustes_test {

using namespace tact;
using Eigen::MatrixXd;

namespace {

// A rotation, or with `mirror` a reflection.
MatrixXd turn(Eigen::Index k, std::uint32_t seed, bool mirror) {
    MatrixXd result = Eigen::HouseholderQR<MatrixXd>(random_map(k, k, seed)).householderQ();
    if ((result.determinant() < 0.0) != mirror) result.col(0) = -result.col(0);
    return result;
}

MatrixXd centred(const MatrixXd& map) { return map.rowwise() - map.colwise().mean(); }

double size(const MatrixXd& map) { return centred(map).norm(); }

double unlikeness(const MatrixXd& a, const MatrixXd& b) {
    const double r = procrustes(a, b).correlation;
    return std::sqrt(1.0 - r * r);
}

}  // namespace

TEST_CASE("procrustes: undoes rotation, reflection, shift and scale") {
    for (const bool mirror : {false, true}) {
        for (const double scale : {0.01, 1.0, 250.0}) {
            const MatrixXd target = random_map(9, 3, 1);
            const MatrixXd moving = (scale * target * turn(3, 2, mirror)).rowwise() +
                                    Eigen::RowVector3d(1.0, -2.0, 3.0);
            const ProcrustesFit fit = procrustes(moving, target);
            CHECK((fit.aligned - target).cwiseAbs().maxCoeff() <= 1e-12);
            CHECK(std::abs(fit.correlation - 1.0) <= 1e-12);
        }
    }
}

TEST_CASE("procrustes: without scale, size is kept") {
    for (const double scale : {0.1, 7.0}) {
        const MatrixXd target = random_map(9, 3, 3);
        const MatrixXd moving = scale * target * turn(3, 4, true);
        const ProcrustesFit fit = procrustes(moving, target, false);
        CHECK(std::abs(size(fit.aligned) / size(moving) - 1.0) <= 1e-14);
        CHECK((centred(fit.aligned) - scale * centred(target)).cwiseAbs().maxCoeff() <= 1e-12);
        CHECK((fit.aligned.colwise().mean() - target.colwise().mean()).norm() <= 1e-13);
    }
}

// The example of R's smacof::Procrustes; K = sqrt(1 - r^2) from NumPy.
TEST_CASE("procrustes: correlations of two worked examples") {
    MatrixXd x(4, 2);
    x << 1, 2, -1, 2, -1, -2, 1, -2;
    MatrixXd y(4, 2);
    y << .07, 2.62, .93, 3.12, 1.93, 1.38, 1.07, .88;
    // 1 - r^2 is 1.6e-5, so rounding of r grows by 250.
    CHECK(std::abs(unlikeness(x, y) - .00399313769970) <= 1e-12);
    CHECK(std::abs(unlikeness(y, x) - .00399313769970) <= 1e-12);

    MatrixXd tetrahedron(4, 3);
    tetrahedron << 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1;
    MatrixXd square(4, 3);
    square << 0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0;
    CHECK(std::abs(unlikeness(tetrahedron, square) - .593630344692143) <= 2e-15);
}

TEST_CASE("procrustes: what remains is the target's size times 1 - r^2") {
    const MatrixXd moving = random_map(8, 3, 5);
    const MatrixXd target = random_map(8, 3, 6);
    const ProcrustesFit fit = procrustes(moving, target);
    CHECK(fit.correlation > 0.0);
    CHECK(fit.correlation < 0.95);
    const double expected = size(target) * size(target) * (1.0 - fit.correlation * fit.correlation);
    CHECK(std::abs((fit.aligned - target).squaredNorm() - expected) <= 1e-13);
}

TEST_CASE("procrustes: no other rotation, reflection or size comes nearer") {
    const MatrixXd moving = random_map(8, 3, 7);
    const MatrixXd target = random_map(8, 3, 8);
    const double kept = (procrustes(moving, target, false).aligned - target).squaredNorm();
    const double scaled = (procrustes(moving, target).aligned - target).squaredNorm();
    CHECK(scaled < kept);
    for (std::uint32_t seed = 0; seed < 200; ++seed) {
        const MatrixXd other =
            (centred(moving) * turn(3, seed, seed % 2 == 0)).rowwise() + target.colwise().mean();
        CHECK((other - target).squaredNorm() >= kept);
        const MatrixXd resized = 0.01 * (1 + seed) * centred(other);
        CHECK((resized - centred(target)).squaredNorm() >= scaled);
    }
}

TEST_CASE("procrustes: a map without extent is only shifted") {
    const MatrixXd point = MatrixXd::Constant(5, 3, 0.1);
    const MatrixXd target = random_map(5, 3, 9);
    const ProcrustesFit fit = procrustes(point, target);
    CHECK(fit.correlation == 0.0);
    CHECK((fit.aligned.rowwise() - target.colwise().mean()).cwiseAbs().maxCoeff() <= 1e-15);
    // And a map onto a point keeps its shape and size.
    const ProcrustesFit onto = procrustes(target, point);
    CHECK(onto.correlation == 0.0);
    CHECK((centred(onto.aligned) - centred(target)).cwiseAbs().maxCoeff() <= 1e-15);
    CHECK(procrustes(MatrixXd(0, 3), MatrixXd(0, 3)).aligned.rows() == 0);
    CHECK(procrustes(random_map(1, 3, 1), random_map(1, 3, 2)).aligned.allFinite());
}

TEST_CASE("procrustes: very small and very large maps are maps") {
    const MatrixXd target = random_map(6, 2, 10);
    for (const double scale : {1e-200, 1e200}) {
        const ProcrustesFit fit = procrustes(scale * target * turn(2, 11, false), target);
        CHECK((fit.aligned - target).cwiseAbs().maxCoeff() <= 1e-12);
    }
}

}  // namespace procrustes_test
