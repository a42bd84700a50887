#include "model/evaluation/nuisance.h"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>

#include "model/pattern/pattern.h"

namespace duration_control_test {

using namespace tact;

namespace {

constexpr double kNotRated = std::numeric_limits<double>::quiet_NaN();

// Four patterns: two of half a second, two of a second.
const std::vector<double> kLastingS{0.5, 0.5, 1.0, 1.0};

}  // namespace

TEST_CASE("duration: a rhythm sounds until its last note ends, whatever silence follows") {
    Pattern pattern;
    pattern.rhythm = {"x-x==---", 0.1};
    pattern.duration_s = 0.8;
    CHECK(std::abs(sounding_s(render(pattern)) - 0.5) <= 1.0 / kModelRateHz);
    pattern.amplitude_g = 0.0;
    CHECK(sounding_s(render(pattern)) == 0.0);
}

TEST_CASE("duration: only pairs that last equally long, and are rated, are counted as such") {
    const Dissimilarity metric{4, {1, 2, 3, 4, 5, 6}};
    const DurationControl all = duration_control(metric, {4, {6, 5, 4, 3, 2, 1}}, kLastingS);
    CHECK(all.equal_pairs == 2);
    CHECK(all.rho_of_equal == -1.0);
    const DurationControl fewer =
        duration_control(metric, {4, {kNotRated, 5, 4, 3, 2, 1}}, kLastingS);
    CHECK(fewer.equal_pairs == 1);
    CHECK(std::isnan(fewer.rho_of_equal));
}

TEST_CASE("duration: a metric that is length itself says nothing beyond it") {
    const Dissimilarity length{4, {0.0, 0.5, 0.5, 0.5, 0.5, 0.0}};
    const DurationControl control = duration_control(length, {4, {1, 4, 6, 5, 3, 2}}, kLastingS);
    CHECK(std::isnan(control.partial_rho));
    CHECK(control.rho_of_length > 0.7);
}

TEST_CASE("duration: values that differ by rounding alone are one") {
    CHECK(distinct_values({3, {1.0, 1.0 + 1e-12, 2.0}}) == 2);
    CHECK(distinct_values({3, {1.0, 1.001, 2.0}}) == 3);
    CHECK(distinct_values({}) == 0);
}

}  // namespace duration_control_test
