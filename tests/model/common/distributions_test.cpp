#include "model/common/distributions.h"

#include <cmath>
#include <limits>

#include "tests/support/golden.h"

namespace student_t_test {

using namespace tact;

TEST_CASE("Student's t: p and quantiles as SciPy has them") {
    for (const auto& one : golden::read("metric_statistics.json", "student")) {
        const auto freedom = one.at("freedom").get<std::size_t>();
        CAPTURE(freedom);
        CHECK(std::abs(two_sided_p(one.at("t"), freedom) - one.at("p").get<double>()) <= 1e-13);
        const auto quantile = one.at("quantile").get<double>();
        // SciPy finds its quantiles to ten digits.
        CHECK(std::abs(two_sided_quantile(one.at("coverage"), freedom) - quantile) <=
              1e-9 * quantile);
    }
}

TEST_CASE("Student's t: sides do not matter, and many degrees of freedom are the normal ones") {
    CHECK(two_sided_p(-1.7, 6) == two_sided_p(1.7, 6));
    CHECK(std::abs(two_sided_quantile(0.95, 0) - 1.959963984540054) <= 1e-12);
    CHECK(std::abs(two_sided_p(1.7, 100'000) - two_sided_p(1.7, 0)) <= 1e-5);
    CHECK(two_sided_p(0.0, 3) == 1.0);
    CHECK(two_sided_p(std::numeric_limits<double>::infinity(), 3) == 0.0);
    CHECK(std::isnan(two_sided_p(std::numeric_limits<double>::quiet_NaN(), 3)));
}

}  // namespace student_t_test
