#include "model/dissimilarity/permutation.h"

#include <cmath>
#include <limits>

#include "tests/support/golden.h"

namespace holm_test {

using namespace tact;

TEST_CASE("holm: p of several tests as an independent program corrects them") {
    for (const auto& one : golden::read("metric_statistics.json", "holm")) {
        const auto p = one.at("p").get<std::vector<double>>();
        const auto expected = one.at("corrected").get<std::vector<double>>();
        CHECK(golden::worst_difference(holm(p), expected) <= 1e-15);
    }
}

TEST_CASE("holm: what is no test has no say in the others") {
    constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
    const std::vector<double> corrected = holm(std::vector<double>{kNone, 0.02, 0.01});
    CHECK(std::isnan(corrected[0]));
    CHECK(corrected[1] == 0.02);
    CHECK(corrected[2] == 0.02);
    CHECK(holm({}).empty());
}

}  // namespace holm_test
