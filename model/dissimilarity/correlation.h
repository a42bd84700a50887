// How well two dissimilarity matrices of the same objects agree in order.
//
// Source    Spearman 1904; Kendall 1945 (tau-b), counted as in Knight 1966; Mantel 1967; bootstrap
//           over objects: Efron 1979.
// Input     values are quantised before they are ranked; ties share their average rank
// Output    correlations in [-1, 1]. NaN where either side is constant or fewer than two pairs are
//           known: nothing then has an order.
// Valid     a pair that is not finite on either side is left out of both
// Left out  Pearson's r: metrics are at best ordinal.
// Exact     same input, same bits, on any number of threads.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "model/common/distributions.h"
#include "model/dissimilarity/dissimilarity.h"
#include "model/dissimilarity/permutation.h"
#include "model/dissimilarity/resampling.h"

namespace tact {

// Ranks of the quantised values minus their mean: halves of whole numbers, so that sums of their
// products are exact for any matrix that people could rate, in any order.
std::vector<double> centred_ranks(std::span<const double> values);

// Pearson's r of centred ranks, which is Spearman's rho; NaN where either side is constant.
double rho_of_ranks(std::span<const double> a, std::span<const double> b);

// Pearson's r of the average ranks; never 1 - 6 sum d^2 / (n (n^2 - 1)), which is wrong for ties.
double spearman(std::span<const double> a, std::span<const double> b);

// Spearman's rho of what a third quantity `given` does not say of either: r of the ranks, partial.
// Source: Kendall 1942. NaN where a rank of `given` says all of one side, or as spearman().
double partial_spearman(std::span<const double> a, std::span<const double> b,
                        std::span<const double> given);

// (concordant - discordant) / sqrt((pairs untied in a) (pairs untied in b)).
double kendall_tau_b(std::span<const double> a, std::span<const double> b);

// One-sided: how often objects of `b` in another order agree with `a` at least as well. Pairs of
// one object are not independent, so no table of Spearman's rho tells. p = NaN where rho is.
PermutationTest mantel(const Dissimilarity& a, const Dissimilarity& b,
                       const PermutationParams& params);

struct BootstrapParams {
    std::size_t draws = 2000;
    double coverage = 0.95;
    std::uint64_t seed = 2;
    int threads = 0;  // 0: all cores
};

// Spearman's rho and a normal quantile times its standard error when objects are drawn with
// replacement; pairs of an object with its own copy are dropped. NaN where rho is, where most draws
// leave it undefined, or where none moves it.
Interval bootstrap_interval(const Dissimilarity& a, const Dissimilarity& b,
                            const BootstrapParams& params);

// The same of the partial rho, with the same draws.
Interval partial_bootstrap_interval(const Dissimilarity& a, const Dissimilarity& b,
                                    const Dissimilarity& given, const BootstrapParams& params);

}  // namespace tact
