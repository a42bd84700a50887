// Permutation of objects: how often two structures on the same objects agree as well by chance.
//
// Source    Mantel 1967; Phipson & Smyth 2010 (the observed order counts among those drawn).
// Output    p = c / n! of all orders for n <= 7, else (c + 1) / (B + 1) of B drawn ones
// Exact     same input, same p, on any number of threads.
#pragma once

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "model/dissimilarity/dissimilarity.h"

namespace tact {

struct PermutationParams {
    std::size_t draws = 10'000;
    std::uint64_t seed = 1;
    int threads = 0;  // 0: all cores
};

struct PermutationTest {
    double p = 1.0;
    std::size_t as_good = 0;  // c; of all orders with the observed one, of drawn ones without
    std::size_t orders = 0;   // n! or B
    bool is_exact = false;
};

// `is_as_good` gets an order of the objects 0 .. n - 1 and tells whether it agrees at least as well
// as the observed one, from any thread. For the observed order it must be true.
PermutationTest permutation_test(
    std::size_t objects, const PermutationParams& params,
    const std::function<bool(std::span<const std::size_t>)>& is_as_good);

// A condensed matrix as an n x n one, 0 on the diagonal.
Eigen::MatrixXd square_of(const Dissimilarity& dissimilarity);

// Sum over the pairs i < j of a(i, j) b(order[i], order[j]), always in the order of the pairs.
double permuted_product(std::span<const double> a, const Eigen::MatrixXd& b,
                        std::span<const std::size_t> order);

// P-values of several tests at once.
//
// Source    Holm 1979: the k-th smallest of m is multiplied by m - k + 1; none falls below one that
//           was smaller. The chance of any false finding stays below the level.
// Input     p; NaN: there is no such test, and it does not count
// Left out  what assumes independent tests (Hochberg 1988): metrics of one set are not.

std::vector<double> holm(std::span<const double> p);

}  // namespace tact
