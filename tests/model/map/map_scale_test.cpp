#include "model/map/map_scale.h"

#include <doctest/doctest.h>

#include <limits>

namespace tact::map_scale_test {

namespace {

Eigen::MatrixXd on_a_line() {
    Eigen::MatrixXd places(4, 3);
    places << 0, 0, 0, 3, 4, 0, 6, 8, 0, 12, 16, 0;
    return places;
}

// Distances of the line, 5 to one.
Dissimilarity fifths() { return {4, {1.0, 2.0, 4.0, 1.0, 3.0, 2.0}}; }

}  // namespace

TEST_CASE("map scale: where distances are proportional it is their factor") {
    CHECK(length_of_one(on_a_line(), fifths()) == doctest::Approx(5.0));
    CHECK(length_of_one(2.0 * on_a_line(), fifths()) == doctest::Approx(10.0));
}

// numpy.linalg.lstsq of [[1], [2]] and [2, 3]: 8 / 5.
TEST_CASE("map scale: elsewhere it is the slope of least squares through 0") {
    Eigen::MatrixXd places(3, 1);
    places << 0, 2, -3;
    Dissimilarity two{3, {1.0, 2.0, std::numeric_limits<double>::quiet_NaN()}};
    CHECK(length_of_one(places, two) == doctest::Approx(1.6));
}

TEST_CASE("map scale: there is none of no pairs, of all alike and of another number of places") {
    CHECK(length_of_one(Eigen::MatrixXd::Zero(1, 3), {1, {}}) == 0.0);
    CHECK(length_of_one(on_a_line(), {4, std::vector<double>(6, 0.0)}) == 0.0);
    CHECK(length_of_one(on_a_line().topRows(3), fifths()) == 0.0);
    const Eigen::MatrixXd nowhere =
        Eigen::MatrixXd::Constant(4, 3, std::numeric_limits<double>::quiet_NaN());
    CHECK(length_of_one(nowhere, fifths()) == 0.0);
}

}  // namespace tact::map_scale_test
