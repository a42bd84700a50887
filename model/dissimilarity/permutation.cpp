#include "model/dissimilarity/permutation.h"

#include <algorithm>
#include <atomic>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <vector>

#include "model/common/parallel.h"
#include "model/common/random.h"

namespace tact {

namespace {

constexpr std::size_t kMostExact = 7;  // 5,040 orders

using Judge = std::function<bool(std::span<const std::size_t>)>;

PermutationTest all_orders(std::size_t objects, const Judge& is_as_good) {
    PermutationTest test;
    test.is_exact = true;
    std::vector<std::size_t> order(objects);
    std::iota(order.begin(), order.end(), std::size_t{0});
    do {
        ++test.orders;
        if (is_as_good(order)) ++test.as_good;
    } while (std::ranges::next_permutation(order).found);
    test.p = static_cast<double>(test.as_good) / static_cast<double>(test.orders);
    return test;
}

}  // namespace

PermutationTest permutation_test(std::size_t objects, const PermutationParams& params,
                                 const Judge& is_as_good) {
    if (objects <= kMostExact) return all_orders(objects, is_as_good);
    // In pieces, so that an order is allocated once for many draws.
    constexpr std::size_t kPiece = 256;
    std::atomic<std::size_t> as_good{0};
    const auto run = [&](std::size_t piece) {
        std::vector<std::size_t> order(objects);
        const std::size_t end = std::min((piece + 1) * kPiece, params.draws);
        for (std::size_t draw = piece * kPiece; draw < end; ++draw) {
            RandomStream random{random_bits(params.seed, draw)};
            next_permutation_of(random, order);
            if (is_as_good(order)) as_good.fetch_add(1);
        }
    };
    parallel_for((params.draws + kPiece - 1) / kPiece, params.threads, {}, run);
    PermutationTest test;
    test.as_good = as_good;
    test.orders = params.draws;
    test.p = static_cast<double>(test.as_good + 1) / static_cast<double>(test.orders + 1);
    return test;
}

Eigen::MatrixXd square_of(const Dissimilarity& dissimilarity) {
    const auto n = static_cast<Eigen::Index>(dissimilarity.size);
    Eigen::MatrixXd square = Eigen::MatrixXd::Zero(n, n);
    std::size_t p = 0;
    for (Eigen::Index i = 0; i < n; ++i) {
        for (Eigen::Index j = i + 1; j < n; ++j, ++p) {
            square(i, j) = square(j, i) = dissimilarity.condensed[p];
        }
    }
    return square;
}

double permuted_product(std::span<const double> a, const Eigen::MatrixXd& b,
                        std::span<const std::size_t> order) {
    assert(a.size() == pair_count(order.size()) && "one value a pair");
    double sum = 0.0;
    std::size_t p = 0;
    for (std::size_t i = 0; i < order.size(); ++i) {
        const auto row = b.col(static_cast<Eigen::Index>(order[i]));
        for (std::size_t j = i + 1; j < order.size(); ++j, ++p) {
            sum += a[p] * row(static_cast<Eigen::Index>(order[j]));
        }
    }
    return sum;
}

std::vector<double> holm(std::span<const double> p) {
    std::vector<std::size_t> rising;
    for (std::size_t k = 0; k < p.size(); ++k) {
        if (!std::isnan(p[k])) rising.push_back(k);
    }
    std::ranges::stable_sort(rising, {}, [p](std::size_t k) { return p[k]; });
    std::vector<double> corrected(p.begin(), p.end());
    double before = 0.0;
    for (std::size_t k = 0; k < rising.size(); ++k) {
        const auto left = static_cast<double>(rising.size() - k);
        before = std::max(before, std::min(1.0, left * p[rising[k]]));
        corrected[rising[k]] = before;
    }
    return corrected;
}

}  // namespace tact
