#include "model/training/training_kernel.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "model/dissimilarity/correlation.h"
#include "tests/support/training_problem.h"

namespace training_kernel_test {

using namespace tact;

namespace {

struct alignas(64) Line {
    std::int32_t numbers[16];
};

// What a kernel makes of a set of pairs whose ranks are drawn from `levels`.
struct Mixed {
    std::vector<std::int32_t> nc;
    std::vector<std::int32_t> oc;
    std::vector<std::int32_t> nc_weight;
    std::vector<std::int32_t> oc_weight;
    std::vector<std::int32_t> ratings;
    std::vector<std::uint64_t> mixed;
    double squares = 0.0;
};

std::vector<std::int32_t> twice_ranks(RandomStream& random, std::size_t pairs, std::size_t levels) {
    std::vector<double> values;
    for (std::size_t k = 0; k < pairs; ++k) {
        values.push_back(static_cast<double>(next_index(random, levels)));
    }
    std::vector<std::int32_t> ranks;
    for (const double rank : average_ranks(values)) {
        ranks.push_back(static_cast<std::int32_t>(2.0 * rank));
    }
    return ranks;
}

Mixed random_mixed(std::uint64_t seed, std::size_t pairs, std::size_t levels) {
    RandomStream random{seed};
    Mixed of;
    of.nc = twice_ranks(random, pairs, levels);
    of.oc = twice_ranks(random, pairs, levels);
    std::ranges::sort(of.oc);
    of.ratings = twice_ranks(random, pairs, levels);
    for (std::int32_t& rank : of.ratings) {
        rank -= static_cast<std::int32_t>(pairs) + 1;
        of.squares += static_cast<double>(rank) * rank;
    }
    for (std::size_t l = 0; l < kMixes; ++l) {
        of.nc_weight.push_back(static_cast<std::int32_t>(1 + next_index(random, 10)));
        of.oc_weight.push_back(static_cast<std::int32_t>(next_index(random, 11)));
    }
    const std::size_t words = (pairs + 63) / 64;
    of.mixed.resize(pairs * words);
    for (std::size_t k = 0; k < pairs; ++k) {
        for (std::size_t j = k + 1; j < pairs; ++j) {
            if (of.nc[j] <= of.nc[k]) of.mixed[k * words + j / 64] |= std::uint64_t{1} << j % 64;
        }
    }
    return of;
}

std::vector<double> rhos(void (*rank)(const MixBatch&), const Mixed& of) {
    const std::size_t pairs = of.nc.size();
    std::vector<Line> value(pairs * kMixes / 16);
    std::vector<Line> excess(pairs * kMixes / 16);
    std::vector<double> rho(kMixes);
    MixBatch batch;
    batch.pairs = pairs;
    batch.nc_rank = of.nc.data();
    batch.oc_rank = of.oc.data();
    batch.mixed = of.mixed.data();
    batch.words = (pairs + 63) / 64;
    batch.nc_weight = of.nc_weight.data();
    batch.oc_weight = of.oc_weight.data();
    batch.value = value.data();
    batch.excess = excess.data();
    batch.columns = 1;
    batch.ratings = of.ratings.data();
    batch.squares = &of.squares;
    batch.rho = rho.data();
    rank(batch);
    return rho;
}

}  // namespace

TEST_CASE("training kernel: mixtures have the rho of their sum, to the bit, ties or none") {
    for (const std::size_t pairs : {3UL, 28UL, 64UL, 105UL, 130UL}) {
        for (const std::size_t levels : {3UL, 20UL, 1000UL}) {
            const Mixed of = random_mixed(pairs + levels, pairs, levels);
            const std::vector<double> ratings(of.ratings.begin(), of.ratings.end());
            std::vector<double> expected;
            for (std::size_t l = 0; l < kMixes; ++l) {
                std::vector<double> pm;
                for (std::size_t k = 0; k < pairs; ++k) {
                    pm.push_back(of.nc_weight[l] * of.nc[k] + of.oc_weight[l] * of.oc[k]);
                }
                expected.push_back(spearman(pm, ratings));
            }
            for (const TrainingKernel& kernel : training_kernels()) {
                INFO(kernel.name << ", " << pairs << " pairs, " << levels << " levels");
                const auto narrow = rhos(kernel.rank_mixes, of);
                const auto wide = rhos(kernel.rank_wide_mixes, of);
                for (std::size_t l = 0; l < kMixes; ++l) {
                    const bool none = std::isnan(expected[l]);
                    CHECK((none ? std::isnan(narrow[l]) : narrow[l] == expected[l]));
                    CHECK((none ? std::isnan(wide[l]) : wide[l] == expected[l]));
                }
            }
        }
    }
}

TEST_CASE("training kernel: forms have the ranks of their values, for every weight beside it") {
    RandomStream random{5};
    constexpr std::size_t kPairs = 71;
    std::vector<std::int32_t> form(kPairs * kFormTerms);
    for (std::int32_t& term : form) term = static_cast<std::int32_t>(next_index(random, 4));
    for (const TrainingKernel& kernel : training_kernels()) {
        const std::size_t width = kernel.weights;
        std::vector<Line> products(kFormTerms);
        auto* product = reinterpret_cast<std::int32_t*>(products.data());
        for (std::size_t k = 0; k < kFormTerms * width; ++k) {
            product[k] = static_cast<std::int32_t>(next_index(random, 6)) - 2;
        }
        std::vector<Line> value(kPairs);
        std::vector<Line> rank(kPairs);
        auto* ranks = reinterpret_cast<std::int32_t*>(rank.data());
        kernel.rank_forms(
            {kPairs, form.data(), product, reinterpret_cast<std::int32_t*>(value.data()), ranks});
        for (std::size_t v = 0; v < width; ++v) {
            std::vector<double> sums;
            for (std::size_t k = 0; k < kPairs; ++k) {
                double sum = 0.0;
                for (std::size_t t = 0; t < kFormTerms; ++t) {
                    sum += form[k * kFormTerms + t] * product[t * width + v];
                }
                sums.push_back(sum);
            }
            const auto expected = average_ranks(sums);
            for (std::size_t k = 0; k < kPairs; ++k) CHECK(ranks[k * width + v] == 2 * expected[k]);
        }
    }
}

TEST_CASE("training kernel: sixteen bits hold sets of 40 patterns by tenths, not of 41") {
    CHECK(fits_narrow_mixes(pair_count(40), 10));
    CHECK_FALSE(fits_narrow_mixes(pair_count(41), 10));
    CHECK_FALSE(fits_narrow_mixes(1801, 1));
}

}  // namespace training_kernel_test
