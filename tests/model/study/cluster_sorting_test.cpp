#include "model/study/cluster_sorting.h"

#include <doctest/doctest.h>

#include <cmath>

namespace cluster_sorting_test {

using namespace tact;

namespace {

// Five items sorted into 2, 3 and 4 groups by two people.
const std::vector<Sorting> kFirst{{0, 0, 1, 1, 1}, {0, 0, 1, 2, 2}, {0, 1, 2, 3, 3}};
const std::vector<Sorting> kSecond{{0, 0, 0, 1, 1}, {0, 1, 1, 2, 2}, {0, 1, 1, 2, 3}};

}  // namespace

TEST_CASE("cluster sorting: worked by hand") {
    const Dissimilarity first = sorting_dissimilarity(5, kFirst);
    CHECK(first(0, 1) == doctest::Approx(4.0 / 9.0).epsilon(1e-15));
    CHECK(first(0, 2) == 1.0);
    CHECK(first(2, 3) == doctest::Approx(7.0 / 9.0).epsilon(1e-15));
    CHECK(first(3, 4) == 0.0);
    const Dissimilarity second = sorting_dissimilarity(5, kSecond);
    const auto mean = [&](std::size_t i, std::size_t j) {
        return 500.0 * (first(i, j) + second(i, j));
    };
    CHECK(mean(0, 1) == doctest::Approx(611.111111).epsilon(1e-9));
    CHECK(mean(1, 2) == doctest::Approx(500.0).epsilon(1e-12));
    CHECK(mean(3, 4) == doctest::Approx(222.222222).epsilon(1e-9));
}

TEST_CASE("cluster sorting: names of groups, and their order, say nothing") {
    std::vector<Sorting> renamed = kFirst;
    for (Sorting& sorting : renamed) {
        for (std::size_t& group : sorting) group = 90 - 7 * group;
    }
    std::swap(renamed[0], renamed[2]);
    CHECK(sorting_dissimilarity(5, renamed) == sorting_dissimilarity(5, kFirst));
}

TEST_CASE("cluster sorting: a pair never sorted together is unknown, not far apart") {
    const std::vector<Sorting> subset{{0, 0, kUnsorted}, {0, 1, kUnsorted}};
    const Dissimilarity d = sorting_dissimilarity(3, subset);
    CHECK(d(0, 1) == doctest::Approx(2.0 / 3.0).epsilon(1e-15));
    CHECK(std::isnan(d(0, 2)));
    // Only the rounds that had both count.
    CHECK(sorting_dissimilarity(3, std::vector<Sorting>{{0, 0, kUnsorted}, {0, 1, 1}})(1, 2) ==
          0.0);
    CHECK(std::isnan(sorting_dissimilarity(2, {})(0, 1)));
}

TEST_CASE("cluster sorting: preset rounds leave out the one nearest to the free choice") {
    CHECK(sorting_rounds(30, 5) == std::vector<int>{0, 3, 9, 12, 15});
    CHECK(sorting_rounds(30, 14) == std::vector<int>{0, 3, 6, 9, 12});
    CHECK(sorting_rounds(12, 4) == std::vector<int>{0, 6, 9});
    CHECK(sorting_rounds(3, 2) == std::vector<int>{0});
}

TEST_CASE("cluster sorting: rounds are read as a person writes them") {
    using Rounds = std::vector<int>;
    CHECK(rounds_in("free, 3, 6", 12) == Rounds{0, 3, 6});
    CHECK(rounds_in(" 0;4  12 ", 12) == Rounds{0, 4, 12});
    CHECK(rounds_in("", 12) == Rounds{});
    CHECK(rounds_in(rounds_text({0, 3, 9}), 12) == Rounds{0, 3, 9});
    for (const char* odd : {"1", "13", "2.5", "-3", "three", "3,,x"})
        CHECK_FALSE(rounds_in(odd, 12));
}

}  // namespace cluster_sorting_test
