#include "model/planning/deciding.h"

#include <algorithm>
#include <cmath>

#include "model/common/random.h"
#include "model/dissimilarity/correlation.h"
#include "tests/support/golden.h"

namespace deciding_test {

using namespace tact;

namespace {

Dissimilarity random_matrix(std::size_t patterns, std::uint64_t seed) {
    RandomStream random{random_bits(seed, 0)};
    Dissimilarity matrix{patterns, {}};
    for (std::size_t p = 0; p < pair_count(patterns); ++p) {
        matrix.condensed.push_back(2.0 + next_even(random));
    }
    return matrix;
}

double rho_among(const Dissimilarity& a, const Dissimilarity& b,
                 const std::vector<std::size_t>& places) {
    return spearman(among(a, places).condensed, among(b, places).condensed);
}

}  // namespace

TEST_CASE("deciding: the subset of the lowest rho, as all subsets tell") {
    for (std::uint64_t seed = 0; seed < 5; ++seed) {
        const Dissimilarity a = random_matrix(9, 2 * seed);
        const Dissimilarity b = random_matrix(9, 2 * seed + 1);
        double lowest = 2.0;
        std::vector<bool> inside(9);
        std::fill(inside.begin(), inside.begin() + 5, true);
        do {
            std::vector<std::size_t> places;
            for (std::size_t k = 0; k < 9; ++k) {
                if (inside[k]) places.push_back(k);
            }
            lowest = std::min(lowest, rho_among(a, b, places));
        } while (std::prev_permutation(inside.begin(), inside.end()));
        const auto found = deciding_patterns(a, b, 5);
        REQUIRE(found);
        CHECK(found->patterns.size() == 5);
        CHECK(std::ranges::is_sorted(found->patterns));
        CHECK(found->rho == rho_among(a, b, found->patterns));
        CHECK(found->rho == lowest);
        CHECK(found->rho <= found->rho_all);
        CHECK(found->rho_all == spearman(a.condensed, b.condensed));
    }
}

TEST_CASE("deciding: all patterns are one choice; equal metrics cannot be told anywhere") {
    const Dissimilarity a = random_matrix(6, 20);
    const auto all = deciding_patterns(a, random_matrix(6, 21), 6);
    CHECK(all->patterns == std::vector<std::size_t>{0, 1, 2, 3, 4, 5});
    CHECK(all->rho == all->rho_all);
    CHECK(deciding_patterns(a, a, 4)->rho == 1.0);
    // A metric that says the same of all pairs decides nothing.
    CHECK(std::isnan(deciding_patterns(a, {6, std::vector<double>(15, 1.0)}, 4)->rho));
}

TEST_CASE("deciding: the same on any number of threads, and nothing once stopped") {
    const Dissimilarity a = random_matrix(20, 30);
    const Dissimilarity b = random_matrix(20, 31);
    CHECK(deciding_patterns(a, b, 7, {.threads = 1})->patterns ==
          deciding_patterns(a, b, 7, {.threads = 3})->patterns);
    std::stop_source source;
    source.request_stop();
    CHECK_FALSE(deciding_patterns(a, b, 7, {.stop = source.get_token()}));
}

}  // namespace deciding_test
