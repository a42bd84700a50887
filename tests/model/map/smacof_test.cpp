#include "model/map/smacof.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <random>

#include "model/dissimilarity/dissimilarity.h"
#include "tests/support/made_up_maps.h"

namespace smacof_test {

using namespace tact;

namespace {

// Distances of points in a cube, times 0.5 to 1.5, `levels` > 0: rounded to that many steps.
std::vector<double> noisy(Eigen::Index n, std::uint32_t seed, int levels = 0) {
    std::mt19937 generator(seed);
    std::vector<double> delta = distances(random_map(n, 3, seed));
    for (double& value : delta) {
        value *= 0.5 + static_cast<double>(generator()) / 4294967296.0;
        if (levels > 0) value = std::ceil(value * levels / 4.0);
    }
    return delta;
}

// Forgets every third pair.
std::vector<double> holed(std::vector<double> delta) {
    for (std::size_t p = 0; p < delta.size(); p += 3) {
        delta[p] = std::numeric_limits<double>::quiet_NaN();
    }
    return delta;
}

}  // namespace

TEST_CASE("smacof: stress never rises from step to step") {
    for (const auto& delta : {noisy(12, 1), noisy(12, 2, 4), holed(noisy(12, 3)), noisy(40, 4)}) {
        const PairOrder order = order_pairs(delta);
        const Eigen::Index n = delta.size() == 66 ? 12 : 40;
        const Eigen::MatrixXd start = random_map(n, 3, 99);
        double before = 1.0;
        bool fell = false;
        for (int steps = 0; steps <= 120; ++steps) {
            const Descent descent = descend(order, start, {0.0, steps});
            CHECK(descent.steps <= steps);
            CHECK(descent.stress1 <= before);
            fell = fell || descent.stress1 < 0.9 * before;
            before = descent.stress1;
        }
        CHECK(fell);
    }
}

TEST_CASE("smacof: stress does not rise by rounding at the very end either") {
    for (std::uint32_t seed = 1; seed <= 10; ++seed) {
        const PairOrder order = order_pairs(noisy(12, seed));
        const Eigen::MatrixXd start = random_map(12, 3, seed);
        const Descent end = descend(order, start, {0.0, 3000});
        CHECK(end.stress1 <= descend(order, start, {0.0, end.steps - 1}).stress1);
        CHECK(end.stress1 <= descend(order, start, {0.0, end.steps - 2}).stress1);
    }
}

TEST_CASE("smacof: it ends where a plain step gains less than the tolerance") {
    for (std::uint32_t seed = 1; seed <= 40; ++seed) {
        const PairOrder order = order_pairs(noisy(12, seed));
        const Descent end = descend(order, random_map(12, 3, seed), {1e-7, 3000});
        // The first step of a descent is plain.
        CHECK(end.stress1 - descend(order, end.points, {0.0, 1}).stress1 <= 1e-7);
    }
}

TEST_CASE("smacof: the stress told is that of the points") {
    for (const auto& delta : {noisy(12, 1), noisy(12, 2, 4), holed(noisy(12, 3))}) {
        const Descent descent = descend(order_pairs(delta), random_map(12, 3, 5), {});
        const std::vector<double> d = distances(descent.points);
        CHECK(std::abs(descent.stress1 - stress1(d, disparities(delta, d))) <= 1e-14);
    }
}

TEST_CASE("smacof: where it ends, no small move goes lower") {
    const std::vector<double> delta = noisy(12, 1);
    const Descent descent = descend(order_pairs(delta), random_map(12, 3, 6), {});
    REQUIRE(descent.stress1 > 0.01);
    for (std::uint32_t seed = 0; seed < 200; ++seed) {
        const std::vector<double> d =
            distances(descent.points + 1e-4 * random_map(12, 3, 1000 + seed));
        // The last step gained less than 1e-10; a slow valley may hold some hundred such steps.
        CHECK(stress1(d, disparities(delta, d)) >= descent.stress1 - 1e-8);
    }
}

TEST_CASE("smacof: the size of the start does not matter") {
    const PairOrder order = order_pairs(noisy(12, 1));
    const Eigen::MatrixXd start = random_map(12, 3, 7);
    const Descent descent = descend(order, start, {});
    // By an even power of two, so that sums and roots round alike.
    for (const double factor : {0x1p-60, 0x1p60}) {
        const Descent other = descend(order, factor * start, {});
        CHECK(other.stress1 == descent.stress1);
        CHECK(other.points == descent.points);
    }
}

TEST_CASE("smacof: unknown pairs are filled in by the known ones") {
    const Eigen::MatrixXd truth = random_map(20, 2, 8);
    const std::vector<double> d = distances(truth);
    const std::vector<double> delta = holed(d);
    double best = 1.0;
    double worst = 0.0;
    for (std::uint32_t seed = 0; seed < 10; ++seed) {
        const Descent descent = descend(order_pairs(delta), random_map(20, 2, 50 + seed), {});
        if (descent.stress1 >= best) continue;
        best = descent.stress1;
        const std::vector<double> found = distances(descent.points);
        double factor = 0.0;
        double size = 0.0;
        for (std::size_t p = 0; p < d.size(); ++p) {
            factor += d[p] * found[p];
            size += found[p] * found[p];
        }
        worst = 0.0;
        for (std::size_t p = 0; p < d.size(); p += 3) {
            worst = std::max(worst, std::abs(factor / size * found[p] - d[p]));
        }
    }
    CHECK(best < 1e-3);
    // The plane is 2.8 across; order alone leaves a few percent of play.
    CHECK(worst < 0.15);
}

TEST_CASE("smacof: nothing known leaves the map where it is") {
    const PairOrder order = order_pairs(std::vector<double>(3, std::nan("")));
    const Eigen::MatrixXd start = random_map(3, 2, 9);
    const Descent descent = descend(order, start, {});
    CHECK(descent.points == start);
    CHECK(descent.stress1 == 0.0);
}

TEST_CASE("smacof: one that rested and was continued has the bits of one that did not rest") {
    for (const auto& delta : {noisy(12, 1), noisy(12, 2, 4), holed(noisy(12, 3)), noisy(40, 4)}) {
        const PairOrder order = order_pairs(delta);
        const Eigen::Index n = delta.size() == 66 ? 12 : 40;
        for (const bool by_interval : {false, true}) {
            DescentParams params;
            if (by_interval && order.unknown.empty()) params.interval_of = delta;
            const Eigen::MatrixXd start = random_map(n, 3, 31);
            const Descent whole = descend(order, start, params);
            CHECK_FALSE(whole.rests);
            for (const double rest_at : {1e-3, 1e-6}) {
                DescentParams resting = params;
                resting.rest_at = rest_at;
                const Descent rested = descend(order, start, resting);
                REQUIRE(rested.rests);
                CHECK(rested.steps < whole.steps);
                const Descent end = continued(order, rested, params);
                CHECK(end.points == whole.points);
                CHECK(end.stress1 == whole.stress1);
                CHECK(end.steps == whole.steps);
                CHECK_FALSE(end.rests);
            }
        }
    }
}

TEST_CASE("smacof: who watches is told every step, lower each time") {
    const PairOrder order = order_pairs(noisy(12, 1));
    std::vector<double> told;
    const std::function watch = [&told](const Eigen::MatrixXd& points, double stress1) {
        CHECK(points.rows() == 12);
        told.push_back(stress1);
    };
    DescentParams params;
    params.watch = &watch;
    const Descent end = descend(order, random_map(12, 3, 5), params);
    CHECK(std::ranges::is_sorted(told, std::greater{}));
    CHECK(told.size() >= static_cast<std::size_t>(end.steps) - 1);
    CHECK(told.back() == end.stress1);
}

TEST_CASE("smacof: stopped before the first step, it returns the start") {
    std::stop_source source;
    source.request_stop();
    const Descent descent =
        descend(order_pairs(noisy(12, 1)), random_map(12, 3, 7), {}, source.get_token());
    CHECK(descent.steps == 0);
    CHECK(descent.points.allFinite());
    CHECK(descent.stress1 > 0.0);
}

}  // namespace smacof_test
