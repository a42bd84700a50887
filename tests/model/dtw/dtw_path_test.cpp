#include "model/dtw/dtw.h"

#include <doctest/doctest.h>

#include <cmath>

#include "model/common/random.h"

namespace dtw_path_test {

using namespace tact;

namespace {

std::vector<double> drawn(std::uint64_t seed, std::size_t length) {
    RandomStream random{seed};
    std::vector<double> values(length);
    for (double& value : values) value = next_even(random);
    return values;
}

}  // namespace

TEST_CASE("dtw path: the cost along it is the distance, to the last bit") {
    for (const auto& [n, m] : {std::pair{1, 1}, {1, 9}, {7, 3}, {40, 40}, {200, 31}}) {
        const auto a = drawn(1, static_cast<std::size_t>(n));
        const auto b = drawn(2, static_cast<std::size_t>(m));
        for (const double cost : {0.0, 0.2}) {
            const DtwPath path = dtw_path(a, b, cost);
            double sum = 0.0;
            std::size_t last_i = 0;
            std::size_t last_j = 0;
            for (const auto& [i, j] : path.steps) {
                if ((i == last_i) != (j == last_j)) sum += cost;
                sum = std::abs(a[i] - b[j]) + sum;
                last_i = i;
                last_j = j;
            }
            CHECK(path.distance == dtw(std::vector<SignalPair>{{a, b}}, {.waiting_cost = cost})[0]);
            CHECK(sum == path.distance);
        }
    }
}

TEST_CASE("dtw path: it goes from both beginnings to both ends and never back") {
    const auto a = drawn(3, 50);
    const auto b = drawn(4, 37);
    const auto steps = dtw_path(a, b).steps;
    CHECK(steps.front() == std::pair<std::size_t, std::size_t>{0, 0});
    CHECK(steps.back() == std::pair<std::size_t, std::size_t>{49, 36});
    for (std::size_t k = 1; k < steps.size(); ++k) {
        const std::size_t di = steps[k].first - steps[k - 1].first;
        const std::size_t dj = steps[k].second - steps[k - 1].second;
        CHECK(di <= 1);
        CHECK(dj <= 1);
        CHECK(di + dj >= 1);
    }
}

TEST_CASE("dtw path: equal signals walk in step, a delay is a wait at the beginning") {
    const std::vector<double> tap{0.0, 1.0, 0.0, 0.5};
    for (const auto& [i, j] : dtw_path(tap, tap).steps) CHECK(i == j);
    const std::vector<double> later{0.0, 0.0, 0.0, 1.0, 0.0, 0.5};
    const DtwPath path = dtw_path(tap, later);
    CHECK(path.distance == 0.0);
    const std::vector<std::pair<std::size_t, std::size_t>> expected{{0, 0}, {0, 1}, {0, 2},
                                                                    {1, 3}, {2, 4}, {3, 5}};
    CHECK(path.steps == expected);
    CHECK(dtw_path({}, {}).steps.empty());
}

}  // namespace dtw_path_test
