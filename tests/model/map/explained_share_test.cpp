#include "model/map/explained_share.h"

#include <doctest/doctest.h>

#include <Eigen/Dense>
#include <limits>
#include <random>
#include <vector>

namespace tact::explained_share_test {

namespace {

struct Example {
    Eigen::MatrixXd places;
    std::vector<double> values;
};

Example random_example(int n, int d, unsigned seed) {
    std::mt19937 random(seed);
    std::normal_distribution<double> normal;
    Example made{Eigen::MatrixXd(n, d), {}};
    for (int k = 0; k < n; ++k) {
        made.values.push_back(normal(random));
        for (int j = 0; j < d; ++j) {
            made.places(k, j) = normal(random) + (j + 1) * 0.4 * made.values.back();
        }
    }
    return made;
}

}  // namespace

TEST_CASE("explained share: it is the R squared of a regression solved by least squares") {
    for (unsigned seed = 1; seed < 20; ++seed) {
        const Example e = random_example(40, seed % 2 == 0 ? 2 : 3, seed);
        Eigen::MatrixXd design(40, 2);
        design.col(0).setOnes();
        design.col(1) = Eigen::Map<const Eigen::VectorXd>(e.values.data(), 40);
        const Eigen::MatrixXd fitted = design * design.colPivHouseholderQr().solve(e.places).eval();
        const Eigen::MatrixXd off = e.places.rowwise() - e.places.colwise().mean();
        const double rest = (e.places - fitted).squaredNorm() / off.squaredNorm();
        CHECK(explained_share(e.places, e.values) == doctest::Approx(1.0 - rest).epsilon(1e-10));
    }
}

TEST_CASE("explained share: all of a line, whatever its direction, its scale and its order") {
    Eigen::MatrixXd places(5, 3);
    std::vector<double> values;
    for (int k = 0; k < 5; ++k) {
        values.push_back(300.0 - 7.0 * k * k);
        places.row(k) = Eigen::RowVector3d(2.0, -1.0, 0.5) * values.back() * 1e-3;
    }
    CHECK(explained_share(places, values) == doctest::Approx(1.0));
    places.row(1).swap(places.row(3));
    std::swap(values[1], values[3]);
    CHECK(explained_share(places, values) == doctest::Approx(1.0));
}

TEST_CASE("explained share: nothing of equal values, of one place, of too few") {
    const Example e = random_example(10, 3, 5);
    CHECK(explained_share(e.places, std::vector<double>(10, 0.1)) == 0.0);
    CHECK(explained_share(Eigen::MatrixXd::Ones(10, 3), e.values) == 0.0);
    const std::vector<double> two{1.0, 2.0};
    CHECK(explained_share(e.places.topRows(2), two) == 0.0);
}

TEST_CASE("explained share: rows that are not finite count for nothing") {
    Example e = random_example(12, 2, 9);
    const double whole =
        explained_share(e.places.topRows(10), std::vector(e.values.begin(), e.values.begin() + 10));
    e.places(10, 1) = std::numeric_limits<double>::quiet_NaN();
    e.values[11] = std::numeric_limits<double>::infinity();
    CHECK(explained_share(e.places, e.values) == doctest::Approx(whole).epsilon(1e-12));
}

}  // namespace tact::explained_share_test
