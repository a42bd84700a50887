#include "model/map/isotonic.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <random>

namespace isotonic_test {

using namespace tact;

namespace {

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

// Sums of a few numbers of order 1.
constexpr double kRounding = 1e-14;

std::vector<double> random_values(std::size_t count, std::uint32_t seed) {
    std::mt19937 generator(seed);
    std::vector<double> values(count);
    for (double& value : values) value = static_cast<double>(generator()) / 4294967296.0;
    return values;
}

double worst(const std::vector<double>& a, const std::vector<double>& b) {
    REQUIRE(a.size() == b.size());
    double result = 0.0;
    for (std::size_t k = 0; k < a.size(); ++k) result = std::max(result, std::abs(a[k] - b[k]));
    return result;
}

// The same fit from its closed form, max over a <= k of min over b >= k of mean(a..b).
std::vector<double> max_min_fit(const std::vector<double>& values,
                                const std::vector<double>& weights) {
    std::vector<double> result;
    for (std::size_t k = 0; k < values.size(); ++k) {
        double highest = -1e300;
        for (std::size_t a = 0; a <= k; ++a) {
            double lowest = 1e300;
            double sum = 0.0;
            double weight = 0.0;
            for (std::size_t b = a; b < values.size(); ++b) {
                sum += weights[b] * values[b];
                weight += weights[b];
                if (b >= k) lowest = std::min(lowest, sum / weight);
            }
            highest = std::max(highest, lowest);
        }
        result.push_back(highest);
    }
    return result;
}

}  // namespace

TEST_CASE("monotone fit: adjacent violators share their mean") {
    const std::vector<double> values{1, 3, 2, 4, 3, 5};
    CHECK(monotone_fit(values) == std::vector<double>{1, 2.5, 2.5, 3.5, 3.5, 5});
    CHECK(monotone_fit(std::vector<double>{4, 1, 3}, std::vector<double>{1, 3, 1}) ==
          std::vector<double>{1.75, 1.75, 3});
}

TEST_CASE("monotone fit: agrees with its max-min form") {
    for (std::uint32_t seed = 1; seed <= 20; ++seed) {
        const std::vector<double> values = random_values(30, seed);
        std::vector<double> weights = random_values(30, seed + 1000);
        for (double& weight : weights) weight += 0.1;
        CHECK(worst(monotone_fit(values, weights), max_min_fit(values, weights)) <= kRounding);
        CHECK(worst(monotone_fit(values), max_min_fit(values, std::vector<double>(30, 1.0))) <=
              kRounding);
    }
}

TEST_CASE("monotone fit: never falls, keeps the mean, leaves ordered values alone") {
    const std::vector<double> values = random_values(500, 3);
    const std::vector<double> fitted = monotone_fit(values);
    CHECK(std::ranges::is_sorted(fitted));
    const double mean = std::accumulate(values.begin(), values.end(), 0.0) / 500.0;
    CHECK(std::abs(std::accumulate(fitted.begin(), fitted.end(), 0.0) / 500.0 - mean) <= kRounding);
    CHECK(monotone_fit(fitted) == fitted);
    CHECK(monotone_fit({}).empty());
}

TEST_CASE("monotone fit: a value without weight follows its neighbours") {
    const std::vector<double> fitted =
        monotone_fit(std::vector<double>{1, 9, 2}, std::vector<double>{1, 0, 1});
    CHECK(fitted == std::vector<double>{1, 2, 2});
}

TEST_CASE("disparities: tied pairs take the order of their distances") {
    const std::vector<double> first{1, 3, 2, 2.5};
    const std::vector<double> fitted = disparities(std::vector<double>{1, 2, 2, 3}, first);
    CHECK(fitted == std::vector<double>{1, 2.75, 2, 2.75});
    CHECK(std::abs(stress1(first, fitted) - 0.0785674201318386) <= 1e-15);

    const std::vector<double> second{2, 1.5, 1, 3, 2.5, 4};
    const std::vector<double> delta{3, 1, 2, 2, 5, 4};
    CHECK(std::abs(stress1(second, disparities(delta, second)) - 0.21320071635561) <= 1e-14);
}

TEST_CASE("disparities: tied pairs may have to be equal, or to be in order on average") {
    const std::vector<double> delta{1, 2, 2, 3};
    const std::vector<double> d{1, 3, 2, 2.5};
    const auto secondary = disparities(delta, d, Ties::secondary);
    CHECK(secondary == std::vector<double>{1, 2.5, 2.5, 2.5});
    CHECK(std::abs(stress1(d, secondary) - 0.157134840263677) <= 1e-15);
    const auto tertiary = disparities(delta, d, Ties::tertiary);
    CHECK(tertiary == d);
    CHECK(stress1(d, tertiary) == 0.0);

    const std::vector<double> second{3, 1, 2, 2, 5, 4};
    const std::vector<double> far{2, 1.5, 1, 3, 2.5, 4};
    CHECK(std::abs(stress1(far, disparities(second, far, Ties::secondary)) - 0.284901441149095) <=
          1e-14);
    CHECK(std::abs(stress1(far, disparities(second, far, Ties::tertiary)) - 0.170940864689457) <=
          1e-14);
}

TEST_CASE("disparities: without ties, all approaches to them agree; with ties, the freer fits") {
    std::vector<double> delta = random_values(28, 8);
    const std::vector<double> d = random_values(28, 9);
    CHECK(worst(disparities(delta, d, Ties::secondary), disparities(delta, d)) <= kRounding);
    CHECK(worst(disparities(delta, d, Ties::tertiary), disparities(delta, d)) <= kRounding);
    for (double& value : delta) value = std::floor(4.0 * value);
    delta[4] = kUnknown;
    const double strict = stress1(d, disparities(delta, d, Ties::secondary));
    CHECK(stress1(d, disparities(delta, d)) < strict);
    CHECK(stress1(d, disparities(delta, d, Ties::tertiary)) < strict);
    CHECK(std::isnan(disparities(delta, d, Ties::tertiary)[4]));
}

TEST_CASE("disparities: of all-tied dissimilarities, every map fits") {
    const std::vector<double> d = random_values(28, 5);
    CHECK(disparities(std::vector<double>(28, 4.0), d) == d);
}

TEST_CASE("disparities: only the order of dissimilarities counts") {
    std::vector<double> delta = random_values(66, 6);
    const std::vector<double> d = random_values(66, 7);
    const std::vector<double> before = disparities(delta, d);
    for (double& value : delta) value = 5.0 + value * value * value;
    CHECK(disparities(delta, d) == before);
}

TEST_CASE("disparities: rounding noise makes no order") {
    const std::vector<double> d{2, 1};
    CHECK(disparities(std::vector<double>{1.0, 1.0 + 1e-15}, d) == d);
    CHECK(disparities(std::vector<double>{1.0, 1.0 + 1e-6}, d) == std::vector<double>{1.5, 1.5});
}

TEST_CASE("disparities: an unknown pair has no say and no part in stress") {
    const std::vector<double> d{1, 3, 2, 2.5, 77, 99};
    const std::vector<double> delta{1, 2, 2, 3, kUnknown, std::numeric_limits<double>::infinity()};
    const std::vector<double> fitted = disparities(delta, d);
    CHECK(std::isnan(fitted[4]));
    CHECK(std::isnan(fitted[5]));
    CHECK(std::abs(stress1(d, fitted) - 0.0785674201318386) <= 1e-15);
}

TEST_CASE("stress: nothing known, or all on one spot, is no misfit") {
    CHECK(stress1({}, {}) == 0.0);
    CHECK(stress1(std::vector<double>{3.0}, std::vector<double>{kUnknown}) == 0.0);
    CHECK(stress1(std::vector<double>{0.0, 0.0}, std::vector<double>{0.0, 0.0}) == 0.0);
}

TEST_CASE("stress: Kruskal's words") {
    CHECK(stress_label(0.0) == "perfect");
    CHECK(stress_label(1e-6) == "excellent");
    CHECK(stress_label(0.025) == "excellent");
    CHECK(stress_label(0.0251) == "good");
    CHECK(stress_label(0.05) == "good");
    CHECK(stress_label(0.051) == "fair");
    CHECK(stress_label(0.10) == "fair");
    CHECK(stress_label(0.101) == "poor");
    CHECK(stress_label(0.9) == "poor");
}

}  // namespace isotonic_test
