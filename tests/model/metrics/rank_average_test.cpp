#include "model/metrics/rank_average.h"

#include "tests/support/golden.h"

namespace rank_average_test {

using namespace tact;

TEST_CASE("rank average: the mean rank of a pair, whatever the units") {
    const std::array parts{Dissimilarity{3, {1.0, 2.0, 3.0}},
                           Dissimilarity{3, {900.0, 100.0, 100.0}}};
    CHECK(rank_average(parts) == Dissimilarity{3, {2.0, 1.75, 2.25}});
}

TEST_CASE("rank average: of one matrix its ranks") {
    const Dissimilarity matrix{3, {0.3, 0.1, 0.3}};
    CHECK(rank_average({&matrix, 1}).condensed == average_ranks(matrix.condensed));
}

}  // namespace rank_average_test
