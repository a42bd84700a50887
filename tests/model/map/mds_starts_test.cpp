// The starts of a map: which are tried, how many, on how many threads, and what comes of them.
#include "model/map/mds.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "tests/support/made_up_maps.h"

namespace mds_starts_test {

using namespace tact;
using Eigen::MatrixXd;

TEST_CASE("mds: the same bits on any number of threads") {
    const Dissimilarity dissimilarity = random_dissimilarity(14, 22);
    MdsParams params = mds_with(3, 40);
    params.turned_points = 20;
    params.threads = 1;
    const PerceptualSpace one = nonmetric_mds(dissimilarity, params);
    for (const int threads : {2, 4}) {
        params.threads = threads;
        const PerceptualSpace many = nonmetric_mds(dissimilarity, params);
        CHECK(many.points == one.points);
        CHECK(many.stress1 == one.stress1);
        CHECK(many.start_stress == one.start_stress);
    }
    params.seed = 2;
    CHECK(nonmetric_mds(dissimilarity, params).start_stress != one.start_stress);
}

TEST_CASE("mds: a start does not depend on how many others there are") {
    const Dissimilarity dissimilarity = random_dissimilarity(10, 23);
    const std::vector<double> few = nonmetric_mds(dissimilarity, mds_with(2, 5)).start_stress;
    const std::vector<double> many = nonmetric_mds(dissimilarity, mds_with(2, 12)).start_stress;
    REQUIRE(few.size() == 6);
    REQUIRE(many.size() == 13);
    CHECK(std::equal(few.begin(), few.end(), many.begin()));
    // Torgerson's is the first.
    const PerceptualSpace alone =
        smacof(dissimilarity, torgerson(dissimilarity, 2), mds_with(2, 0));
    CHECK(alone.stress1 <= few[0]);  // where it rested
    CHECK(alone.stress1 >= few[0] - 1e-4);
}

TEST_CASE("mds: turning badly placed points never leads up, and down where there is no structure") {
    int lower = 0;
    for (std::uint32_t seed = 40; seed < 46; ++seed) {
        const Dissimilarity dissimilarity = random_dissimilarity(25, seed);
        MdsParams params = mds_with(3, 3);
        const PerceptualSpace before = nonmetric_mds(dissimilarity, params);
        params.turned_points = 20;
        const PerceptualSpace after = nonmetric_mds(dissimilarity, params);
        CHECK(after.start_stress == before.start_stress);
        CHECK(after.stress1 <= before.stress1);
        if (after.stress1 < before.stress1 - 1e-4) ++lower;
    }
    CHECK(lower >= 3);
}

TEST_CASE("mds: a map that fits has no points to turn") {
    const Dissimilarity dissimilarity = of_points(random_map(14, 3, 47));
    MdsParams params = mds_with(3, 20);
    const PerceptualSpace before = nonmetric_mds(dissimilarity, params);
    params.turned_points = 20;
    CHECK(nonmetric_mds(dissimilarity, params).points == before.points);
}

TEST_CASE("mds: the map is that of the best start at its end, framed") {
    const Dissimilarity dissimilarity = random_dissimilarity(12, 24);
    const PerceptualSpace space = nonmetric_mds(dissimilarity, mds_with(3, 30));
    const double best = *std::ranges::min_element(space.start_stress);
    CHECK(space.stress1 <= best);
    CHECK(space.stress1 >= best - 1e-4);
    CHECK(best < *std::ranges::max_element(space.start_stress));
    CHECK(space.points.colwise().mean().norm() <= 1e-14);
    double squares = 0.0;
    for (const double d : distances(space.points)) squares += d * d;
    CHECK(std::abs(squares / 66.0 - 1.0) <= 1e-14);
}

TEST_CASE("mds: hardly any start that was left where it rested would have ended lower") {
    for (std::uint32_t seed = 1; seed <= 12; ++seed) {
        CAPTURE(seed);
        // Distances in four dimensions, in few steps or with noise; or no structure.
        Dissimilarity dissimilarity = of_points(random_map(16, 4, seed));
        if (seed % 3 == 0) dissimilarity = random_dissimilarity(16, seed);
        for (double& value : dissimilarity.condensed) {
            if (seed % 3 == 1) value = std::round(4.0 * value);
        }
        const MdsParams params = mds_with(3, 30);
        double least = 1.0;
        for (std::size_t k = 1; k <= 30; ++k) {
            const PerceptualSpace one =
                smacof(dissimilarity, random_start(16, 3, params.seed, k), params);
            least = std::min(least, one.stress1);
        }
        CHECK(nonmetric_mds(dissimilarity, params).stress1 <= least + 1e-4);
    }
}

TEST_CASE("mds: a map is shown on its way, lower each time, and watching changes no bit of it") {
    const Dissimilarity dissimilarity = random_dissimilarity(20, 33);
    const MdsParams params = mds_with(3, 5);
    std::vector<double> seen;
    const PerceptualSpace space =
        nonmetric_mds(dissimilarity, params, {}, {}, [&](const MatrixXd& points) {
            const std::vector<double> d = distances(points);
            seen.push_back(stress1(d, disparities(dissimilarity.condensed, d)));
        });
    REQUIRE(seen.size() > 3);
    CHECK(seen.front() > seen.back());
    CHECK(space.stress1 <= seen.back() + 1e-12);
    for (std::size_t k = 1; k < seen.size(); ++k) CHECK(seen[k] <= seen[k - 1] + 1e-12);
    CHECK(space.points == nonmetric_mds(dissimilarity, params).points);
}

TEST_CASE("mds: a warm start stays in its valley and costs little") {
    const Dissimilarity dissimilarity = random_dissimilarity(12, 25);
    const PerceptualSpace space = nonmetric_mds(dissimilarity, mds_with(3, 30));
    const PerceptualSpace again = smacof(dissimilarity, space.points, mds_with(3, 0));
    CHECK(again.stress1 <= space.stress1 + 1e-14);
    CHECK(again.stress1 >= space.stress1 - 1e-7);
    CHECK((again.points - space.points).cwiseAbs().maxCoeff() < 1e-2);
}

TEST_CASE("mds: a start that cannot be used is replaced") {
    const Dissimilarity dissimilarity = random_dissimilarity(8, 26);
    const MdsParams params = mds_with(3, 0);
    const PerceptualSpace expected = nonmetric_mds(dissimilarity, params);
    MatrixXd hollow = random_map(8, 3, 1);
    hollow(3, 1) = std::nan("");
    for (const MatrixXd& start : {random_map(7, 3, 1), random_map(8, 2, 1), hollow,
                                  MatrixXd(MatrixXd::Constant(8, 3, 4.0)), MatrixXd()}) {
        CHECK(smacof(dissimilarity, start, params).points == expected.points);
    }
}

TEST_CASE("mds: tells how many starts are done") {
    std::vector<std::size_t> told;
    nonmetric_mds(random_dissimilarity(8, 30), mds_with(2, 6), {},
                  [&told](std::size_t done) { told.push_back(done); });
    CHECK(told == std::vector<std::size_t>{1, 2, 3, 4, 5, 6, 7});
}

TEST_CASE("mds: the larger the set, the fewer starts, three above 300 objects") {
    const auto starts = [](std::size_t objects) {
        return standard_mds_params(objects, 3).random_starts;
    };
    CHECK(starts(30) == 100);
    CHECK(starts(31) == 30);
    CHECK(starts(100) == 30);
    CHECK(starts(101) == 10);
    CHECK(starts(300) == 10);
    CHECK(starts(301) == 3);
    CHECK(starts(1000) == 3);
    CHECK(starts(1001) == 0);
}

}  // namespace mds_starts_test
