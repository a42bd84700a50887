#include "model/export/ranks_among.h"

#include <doctest/doctest.h>

namespace ranks_among_test {

using namespace tact;

TEST_CASE("ranks among others: of the others themselves, their average ranks to the bit") {
    const std::vector<double> values{3.0, 1.0, 2.0, 2.0, 0.0, 5.0};
    CHECK(ranks_among(values, values) == average_ranks(values));
}

TEST_CASE("ranks among others: between two of them, below all and above all") {
    const std::vector<double> others{1.0, 2.0, 4.0};
    CHECK(ranks_among(std::vector{0.0, 1.5, 3.0, 9.0}, others) == std::vector{0.5, 1.5, 2.5, 3.5});
    CHECK(ranks_among(std::vector{7.0}, {}) == std::vector{0.5});
}

TEST_CASE("ranks among others: rounding noise makes no order") {
    const std::vector<double> others{1.0, 2.0, 4.0};
    CHECK(ranks_among(std::vector{2.0 + 1e-12}, others) == std::vector{2.0});
}

}  // namespace ranks_among_test
