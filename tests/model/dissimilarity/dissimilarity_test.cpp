#include "model/dissimilarity/dissimilarity.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "tests/support/golden.h"

namespace dissimilarity_test {

using namespace tact;
using golden::Json;

TEST_CASE("dissimilarity: condensed order is (1,2),(1,3)..(2,3).. and back") {
    for (const std::size_t n : {2UL, 3UL, 12UL, 100UL}) {
        std::size_t index = 0;
        for (std::size_t i = 0; i < n; ++i) {
            for (std::size_t j = i + 1; j < n; ++j, ++index) {
                CHECK(pair_index(n, i, j) == index);
                CHECK(pair_at(n, index) == std::pair{i, j});
            }
        }
        CHECK(index == pair_count(n));
    }
    // Where squares no longer fit a double's 53 bits evenly.
    const std::size_t n = 10'000;
    for (const std::size_t index :
         {0UL, 9'998UL, 9'999UL, 25'000'000UL, 49'994'998UL, 49'994'999UL}) {
        const auto [i, j] = pair_at(n, index);
        CHECK(pair_index(n, i, j) == index);
    }
}

TEST_CASE("dissimilarity: symmetric, with a zero diagonal") {
    const Dissimilarity d{3, {1.0, 2.0, 3.0}};
    CHECK(d(0, 1) == 1.0);
    CHECK(d(1, 0) == 1.0);
    CHECK(d(2, 1) == 3.0);
    CHECK(d(2, 2) == 0.0);
}

TEST_CASE("ranks: ties share their average") {
    CHECK(average_ranks(std::vector<double>{10, 20, 20, 40}) ==
          std::vector<double>{1.0, 2.5, 2.5, 4.0});
    CHECK(average_ranks({}).empty());
    CHECK(average_ranks(std::vector<double>{0.0, 0.0}) == std::vector<double>{1.5, 1.5});
}

TEST_CASE("ranks: a rank counts the smaller values and half of the equal ones") {
    // -20..20 in a scattered order, each several times.
    std::vector<double> values(500);
    for (std::size_t k = 0; k < values.size(); ++k) {
        values[k] = static_cast<double>(k * k % 41) - 20.0;
    }
    const std::vector<double> ranks = average_ranks(values);
    for (std::size_t k = 0; k < values.size(); ++k) {
        const auto less = std::ranges::count_if(values, [&](double v) { return v < values[k]; });
        const auto equal = std::ranges::count(values, values[k]);
        // 1 + less .. less + equal share their mean: halves are exact.
        CHECK(ranks[k] == static_cast<double>(2 * less + equal + 1) / 2.0);
    }
    std::vector<double> replaced = values;
    replace_by_ranks(replaced);
    CHECK(replaced == ranks);
}

TEST_CASE("ranks: rounding noise makes no order") {
    const std::vector<double> noisy{1.0, 1.0 + 1e-15, 1.0 - 2e-16};
    CHECK(average_ranks(noisy) == std::vector<double>{2.0, 2.0, 2.0});
    // A part in 1e6 is a difference.
    CHECK(average_ranks(std::vector<double>{1.0, 1.000001}) == std::vector<double>{1.0, 2.0});
}

TEST_CASE("ranks: dissimilarities that are all but zero are equal, however they are ordered") {
    // Rounding noise of a set of equal patterns: a largest value below 1e-6 is no scale.
    CHECK(average_ranks(std::vector<double>{1e-17, 4e-17, 2e-16}) == std::vector{2.0, 2.0, 2.0});
    CHECK(quantised(std::vector<double>{1e-17, -2e-16}) == std::vector{0.0, 0.0});
    CHECK(quantised(std::vector<double>{2e-7, 1e-7}) == std::vector{2e8, 1e8});
    CHECK(quantised(std::vector<double>{2e-6, 1e-6}) == std::vector{1e9, 5e8});
}

TEST_CASE("ties: what differs by rounding noise becomes equal, and no rank changes") {
    std::vector<double> values{0.3, 0.1 + 0.2, 7.0, 0.30001, 0.0};
    REQUIRE(values[0] != values[1]);
    const std::vector<double> before = values;
    tie_rounding_noise(values);
    CHECK(values[0] == values[1]);
    CHECK(values[3] > values[0]);
    CHECK(values[4] == 0.0);
    CHECK(average_ranks(values) == average_ranks(before));
    CHECK(std::abs(values[2] - 7.0) <= 1e-15 * 7.0);
    const std::vector<double> once = values;
    tie_rounding_noise(values);
    CHECK(average_ranks(values) == average_ranks(once));
}

TEST_CASE("dissimilarity: the order of any number of values is that of their quantised forms") {
    std::mt19937_64 random(7);
    std::uniform_int_distribution<int> value(-3000, 3000);  // ties, once there are many
    for (const std::size_t count : {0UL, 1UL, 4095UL, 4096UL, 60'000UL}) {
        CAPTURE(count);
        std::vector<double> values(count);
        for (double& one : values) one = 0.1 * value(random);
        if (count > 10) {
            values[3] = std::numeric_limits<double>::infinity();
            values[5] = std::nan("");
            values[count - 1] = 1e3;
            values[count - 2] = -1e3;
        }
        std::vector<double> finite = values;
        for (double& one : finite) one = std::isfinite(one) ? one : 0.0;
        const std::vector<double> keys = quantised(finite);
        std::vector<std::size_t> expected;
        for (std::size_t k = 0; k < count; ++k) {
            if (std::isfinite(values[k])) expected.push_back(k);
        }
        std::ranges::stable_sort(expected, {}, [&](std::size_t k) { return keys[k]; });
        const std::vector<KeyedPlace> order = by_size(values);
        REQUIRE(order.size() == expected.size());
        CHECK(std::ranges::equal(order, expected, {}, &KeyedPlace::place));
        for (std::size_t k = 1; k < order.size(); ++k) {
            const double apart = keys[expected[k]] - keys[expected[k - 1]];
            CHECK(static_cast<double>(order[k].key - order[k - 1].key) == apart);
        }
    }
}

}  // namespace dissimilarity_test
