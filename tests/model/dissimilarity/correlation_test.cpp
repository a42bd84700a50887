#include "model/dissimilarity/correlation.h"

#include <cmath>
#include <limits>

#include "tests/support/golden.h"

namespace correlation_test {

using namespace tact;
using golden::Json;

namespace {

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

// Sums of a hundred products of order 1.
constexpr double kRounding = 1e-13;

using Values = std::vector<double>;

Values values_of(const Json& list) {
    Values values;
    for (const Json& value : list) {
        values.push_back(value.is_null() ? kUnknown : value.get<double>());
    }
    return values;
}

Dissimilarity matrix_of(const Json& json, const char* side) {
    return {json.at("size"), values_of(json.at(side))};
}

// Two matrices that agree somewhat.
std::pair<Dissimilarity, Dissimilarity> related(std::size_t size, std::uint32_t seed) {
    const Values noise = golden::noise(seed, 2 * pair_count(size), 1.0).samples_g;
    std::pair<Dissimilarity, Dissimilarity> pair{{size, {}}, {size, {}}};
    for (std::size_t p = 0; p < pair_count(size); ++p) {
        pair.first.condensed.push_back(2.0 + noise[p]);
        pair.second.condensed.push_back(4.0 + noise[p] + noise[pair_count(size) + p]);
    }
    return pair;
}

}  // namespace

TEST_CASE("correlation: rho and tau-b are SciPy's, with ties and with unknown pairs") {
    const Json table = golden::read("evaluation.json");
    for (const Json& json : table.at("correlations")) {
        CAPTURE(json.at("name").get<std::string>());
        const Values a = values_of(json.at("a"));
        const Values b = values_of(json.at("b"));
        CHECK(std::abs(spearman(a, b) - json.at("rho").get<double>()) <= kRounding);
        CHECK(std::abs(kendall_tau_b(a, b) - json.at("tau_b").get<double>()) <= kRounding);
    }
}

TEST_CASE("correlation: ties share ranks, which the short formula gets wrong") {
    const Values a{10, 20, 20, 40, 50, 50, 50};
    const Values b{1, 3, 2, 2, 8, 9, 7};
    CHECK(std::abs(spearman(a, b) - 0.877983835257382) <= 1e-15);
    CHECK(std::abs(kendall_tau_b(a, b) - 0.759256602365297) <= 1e-15);
    CHECK(std::abs(spearman(a, b) - 0.883928571) > 1e-3);
}

TEST_CASE("correlation: without an order on either side there is none") {
    const Values rising{1, 2, 3};
    for (const Values& flat : {Values{4, 4, 4}, Values{1, 1 + 1e-15, 1 - 1e-15},
                               Values{5, kUnknown, kUnknown}, Values(3, kUnknown)}) {
        CHECK(std::isnan(spearman(rising, flat)));
        CHECK(std::isnan(spearman(flat, rising)));
        CHECK(std::isnan(kendall_tau_b(rising, flat)));
    }
    CHECK(std::isnan(spearman({}, {})));
    CHECK(std::isnan(kendall_tau_b({}, {})));
}

// Residuals of ranks, after those of `given` and a constant, correlated: SciPy's rankdata and
// pearsonr, NumPy's lstsq, on these lists.
TEST_CASE("partial correlation: that of the ranks' residuals, by SciPy") {
    const Values a{3, 1, 4, 1, 5, 9, 2, 6, 5, 3, 5, 8, 9, 7, 9};
    const Values b{2, 7, 1, 8, 2, 8, 1, 8, 2, 8, 4, 5, 9, 0, 4};
    const Values given{1, 1, 2, 3, 5, 8, 1, 3, 2, 1, 3, 4, 5, 5, 8};
    CHECK(std::abs(partial_spearman(a, b, given) - 0.05553616890107037) < kRounding);
    // What is not known in one is left out of all.
    Values more_a = a;
    Values more_b = b;
    Values more_given = given;
    more_a.push_back(100.0);
    more_b.push_back(100.0);
    more_given.push_back(kUnknown);
    CHECK(partial_spearman(more_a, more_b, more_given) == partial_spearman(a, b, given));
    CHECK(std::isnan(partial_spearman(a, b, a)));
    CHECK(std::isnan(partial_spearman(a, b, Values(15, 1.0))));
}

TEST_CASE("correlation: only the order of either side counts") {
    const auto [a, b] = related(12, 3);
    Values cubes = a.condensed;
    for (double& value : cubes) value = value * value * value;
    CHECK(spearman(cubes, b.condensed) == spearman(a.condensed, b.condensed));
    CHECK(kendall_tau_b(cubes, b.condensed) == kendall_tau_b(a.condensed, b.condensed));
    for (double& value : cubes) value = -value;
    CHECK(spearman(cubes, b.condensed) == -spearman(a.condensed, b.condensed));
    CHECK(spearman(b.condensed, a.condensed) == spearman(a.condensed, b.condensed));
    CHECK(spearman(a.condensed, a.condensed) == 1.0);
    CHECK(kendall_tau_b(a.condensed, a.condensed) == 1.0);
}

TEST_CASE("mantel: of all orders of few objects, as many agree as an enumeration counts") {
    const Json table = golden::read("evaluation.json");
    for (const Json& json : table.at("mantel")) {
        CAPTURE(json.at("name").get<std::string>());
        const PermutationTest test = mantel(matrix_of(json, "a"), matrix_of(json, "b"), {});
        CHECK(test.is_exact);
        CHECK(test.orders == json.at("orders").get<std::size_t>());
        CHECK(test.as_good == json.at("as_good").get<std::size_t>());
        CHECK(test.p == static_cast<double>(test.as_good) / static_cast<double>(test.orders));
    }
}

TEST_CASE("mantel: of drawn orders, as large a share agrees as of all") {
    // Seven objects are counted out; an eighth that nothing is known of makes the program draw.
    const auto [a, b] = related(7, 17);
    const PermutationTest all = mantel(a, b, {});
    REQUIRE(all.is_exact);
    Dissimilarity wide_a{8, Values(28, kUnknown)};
    Dissimilarity wide_b = wide_a;
    for (std::size_t i = 0; i < 7; ++i) {
        for (std::size_t j = i + 1; j < 7; ++j) {
            wide_a.condensed[pair_index(8, i, j)] = a(i, j);
            wide_b.condensed[pair_index(8, i, j)] = b(i, j);
        }
    }
    const PermutationTest drawn = mantel(wide_a, wide_b, {});
    CHECK_FALSE(drawn.is_exact);
    CHECK(drawn.orders == 10'000);
    CHECK(drawn.p == static_cast<double>(drawn.as_good + 1) / 10'001.0);
    // The unknown object leaves other pairs in every order; of 21 pairs it takes six at most, so
    // shares are alike, not equal.
    CHECK(std::abs(drawn.p - all.p) <= 0.05);
}

TEST_CASE("mantel: unrelated matrices have p spread evenly from 0 to 1") {
    int below_half = 0;
    int below_tenth = 0;
    for (std::uint32_t seed = 1; seed <= 200; ++seed) {
        const Dissimilarity a = related(6, seed).first;
        const Dissimilarity b = related(6, seed + 5000).first;
        const double p = mantel(a, b, {}).p;
        below_half += p <= 0.5 ? 1 : 0;
        below_tenth += p <= 0.1 ? 1 : 0;
    }
    // Binomial: 100 and 20, standard deviations 7 and 4.
    CHECK(std::abs(below_half - 100) <= 25);
    CHECK(std::abs(below_tenth - 20) <= 15);
}

TEST_CASE("mantel and bootstrap: the same bits on any number of threads; other seeds, others") {
    const auto [a, b] = related(12, 4);
    PermutationParams one{1000, 1, 1};
    const PermutationParams three{1000, 1, 3};
    CHECK(mantel(a, b, one).as_good == mantel(a, b, three).as_good);
    const Interval single = bootstrap_interval(a, b, {300, 0.95, 2, 1});
    const Interval many = bootstrap_interval(a, b, {300, 0.95, 2, 3});
    CHECK(single.low == many.low);
    CHECK(single.high == many.high);
    CHECK(bootstrap_interval(a, b, {300, 0.95, 7, 1}).low != single.low);
}

TEST_CASE("bootstrap: the interval of another program's 20,000 draws") {
    const Json table = golden::read("evaluation.json");
    const Json& json = table.at("bootstrap");
    const Interval interval =
        bootstrap_interval(matrix_of(json, "a"), matrix_of(json, "b"), {20'000, 0.95, 2, 0});
    // Both are draws: the quantiles scatter by about .003.
    CHECK(std::abs(interval.low - json.at("low").get<double>()) <= 0.015);
    CHECK(std::abs(interval.high - json.at("high").get<double>()) <= 0.015);
}

TEST_CASE("bootstrap: of an order that no draw moves, or of none, there is no interval") {
    const auto [a, b] = related(10, 6);
    CHECK(std::isnan(bootstrap_interval(a, a, {}).low));
    const Interval wide = bootstrap_interval(a, b, {});
    const Interval narrow = bootstrap_interval(a, b, {2000, 0.5, 2, 0});
    CHECK(wide.low < narrow.low);
    CHECK(narrow.low < spearman(a.condensed, b.condensed));
    CHECK(spearman(a.condensed, b.condensed) < narrow.high);
    CHECK(narrow.high < wide.high);
    const Dissimilarity flat{10, Values(45, 1.0)};
    CHECK(std::isnan(bootstrap_interval(a, flat, {}).low));
    CHECK(std::isnan(mantel(a, flat, {}).p));
}

TEST_CASE("quantile: linear between the sorted values") {
    const Values values{1, 2, 4, 8};
    CHECK(quantile(values, 0.0) == 1.0);
    CHECK(quantile(values, 0.5) == 3.0);
    CHECK(quantile(values, 1.0) == 8.0);
    CHECK(quantile(Values{7}, 0.3) == 7.0);
    CHECK(std::isnan(quantile({}, 0.5)));
}

}  // namespace correlation_test
