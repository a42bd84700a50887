#include "model/dissimilarity/correlation.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

#include "model/common/parallel.h"

namespace tact {

namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

struct Columns {
    std::vector<double> a;
    std::vector<double> b;
};

// The pairs that are known on both sides.
Columns known(std::span<const double> a, std::span<const double> b) {
    assert(a.size() == b.size() && "values of the same pairs");
    Columns columns;
    for (std::size_t p = 0; p < a.size(); ++p) {
        if (!std::isfinite(a[p]) || !std::isfinite(b[p])) continue;
        columns.a.push_back(a[p]);
        columns.b.push_back(b[p]);
    }
    return columns;
}

double product(std::span<const double> a, std::span<const double> b) {
    return std::inner_product(a.begin(), a.end(), b.begin(), 0.0);
}

std::uint64_t pairs_of(std::uint64_t count) { return count * (count - 1) / 2; }

// Pairs of equal neighbours in a sorted range.
template <class Equal>
std::uint64_t tied_pairs(std::size_t count, Equal equal) {
    std::uint64_t pairs = 0;
    for (std::size_t first = 0; first < count;) {
        std::size_t end = first + 1;
        while (end < count && equal(first, end)) ++end;
        pairs += pairs_of(end - first);
        first = end;
    }
    return pairs;
}

// Sorts, and counts the pairs that stood in falling order.
std::uint64_t sort_counting(std::span<double> values, std::span<double> room) {
    if (values.size() < 2) return 0;
    const std::size_t middle = values.size() / 2;
    const auto left = values.first(middle);
    const auto right = values.subspan(middle);
    std::uint64_t falling =
        sort_counting(left, room.first(middle)) + sort_counting(right, room.subspan(middle));
    std::size_t l = 0;
    std::size_t r = 0;
    for (double& value : room) {
        const bool takes_left = r == right.size() || (l < left.size() && left[l] <= right[r]);
        if (!takes_left) falling += left.size() - l;
        value = takes_left ? left[l++] : right[r++];
    }
    std::ranges::copy(room, values.begin());
    return falling;
}

// Where every pair is known, ranks do not change with the order of the objects.
PermutationTest mantel_of_complete(const Dissimilarity& a, const Dissimilarity& b,
                                   const PermutationParams& params) {
    const std::vector<double> ranks = centred_ranks(a.condensed);
    const Dissimilarity others{b.size, centred_ranks(b.condensed)};
    const Eigen::MatrixXd square = square_of(others);
    const double observed = product(ranks, others.condensed);
    const double rounding = 1e-12 * product(ranks, ranks);
    return permutation_test(a.size, params, [&](std::span<const std::size_t> order) {
        return permuted_product(ranks, square, order) >= observed - rounding;
    });
}

// `a` with its objects in another order.
std::vector<double> reordered(const Dissimilarity& a, std::span<const std::size_t> order) {
    std::vector<double> condensed;
    condensed.reserve(a.condensed.size());
    for (std::size_t i = 0; i < order.size(); ++i) {
        for (std::size_t j = i + 1; j < order.size(); ++j) {
            // The dissimilarity of a drawn object and its copy is unknown.
            condensed.push_back(order[i] == order[j] ? kNone : a(order[i], order[j]));
        }
    }
    return condensed;
}

bool is_complete(const Dissimilarity& a) {
    return std::ranges::all_of(a.condensed, [](double value) { return std::isfinite(value); });
}

template <class Of>
Interval interval_by_draws(std::size_t objects, const BootstrapParams& params, Of of) {
    std::vector<std::size_t> as_they_are(objects);
    std::iota(as_they_are.begin(), as_they_are.end(), std::size_t{0});
    const double value = of(as_they_are);
    if (std::isnan(value)) return {kNone, kNone};
    const std::vector<ObjectDraw> draws = object_draws(objects, params.draws, params.seed);
    std::vector<Weighed> drawn(draws.size());
    parallel_for(draws.size(), params.threads, {}, [&](std::size_t draw) {
        drawn[draw] = {of(draws[draw].objects), draws[draw].weight};
    });
    return interval_about(value, bootstrap_error(drawn).value, params.coverage, 0, {-1.0, 1.0});
}

}  // namespace

std::vector<double> centred_ranks(std::span<const double> values) {
    std::vector<double> ranks = average_ranks(values);
    const double mean = (static_cast<double>(values.size()) + 1.0) / 2.0;
    for (double& rank : ranks) rank -= mean;
    return ranks;
}

double rho_of_ranks(std::span<const double> a, std::span<const double> b) {
    const double size = std::sqrt(product(a, a) * product(b, b));
    return size > 0.0 ? std::clamp(product(a, b) / size, -1.0, 1.0) : kNone;
}

double spearman(std::span<const double> a, std::span<const double> b) {
    const Columns columns = known(a, b);
    return rho_of_ranks(centred_ranks(columns.a), centred_ranks(columns.b));
}

double partial_spearman(std::span<const double> a, std::span<const double> b,
                        std::span<const double> given) {
    assert(a.size() == b.size() && a.size() == given.size() && "values of the same pairs");
    std::vector<double> x;
    std::vector<double> y;
    std::vector<double> z;
    for (std::size_t p = 0; p < a.size(); ++p) {
        if (!std::isfinite(a[p]) || !std::isfinite(b[p]) || !std::isfinite(given[p])) continue;
        x.push_back(a[p]);
        y.push_back(b[p]);
        z.push_back(given[p]);
    }
    const double xz = spearman(x, z);
    const double yz = spearman(y, z);
    const double left = (1.0 - xz * xz) * (1.0 - yz * yz);
    constexpr double kNothingLeft = 1e-12;
    if (!(left > kNothingLeft)) return kNone;
    return std::clamp((spearman(x, y) - xz * yz) / std::sqrt(left), -1.0, 1.0);
}

double kendall_tau_b(std::span<const double> a, std::span<const double> b) {
    const Columns columns = known(a, b);
    const std::vector<double> x = quantised(columns.a);
    const std::vector<double> y = quantised(columns.b);
    const std::size_t count = x.size();
    std::vector<std::pair<double, double>> sorted(count);
    for (std::size_t k = 0; k < count; ++k) sorted[k] = {x[k], y[k]};
    std::ranges::sort(sorted);
    const std::uint64_t tied_a = tied_pairs(
        count, [&](std::size_t i, std::size_t j) { return sorted[i].first == sorted[j].first; });
    const std::uint64_t tied_both =
        tied_pairs(count, [&](std::size_t i, std::size_t j) { return sorted[i] == sorted[j]; });
    std::vector<double> second(count);
    std::ranges::transform(sorted, second.begin(), &std::pair<double, double>::second);
    std::vector<double> room(count);
    const std::uint64_t discordant = sort_counting(second, room);
    const std::uint64_t tied_b =
        tied_pairs(count, [&](std::size_t i, std::size_t j) { return second[i] == second[j]; });
    const std::uint64_t all = count == 0 ? 0 : pairs_of(count);
    if (tied_a == all || tied_b == all) return kNone;
    const auto number = [](std::uint64_t n) { return static_cast<double>(n); };
    const double excess =
        number(all + tied_both) - number(tied_a + tied_b) - 2 * number(discordant);
    const double size = std::sqrt(number(all - tied_a)) * std::sqrt(number(all - tied_b));
    return std::clamp(excess / size, -1.0, 1.0);
}

PermutationTest mantel(const Dissimilarity& a, const Dissimilarity& b,
                       const PermutationParams& params) {
    assert(a.size == b.size && "matrices of the same objects");
    const double observed = spearman(a.condensed, b.condensed);
    if (std::isnan(observed)) return {kNone, 0, 0, false};
    if (is_complete(a) && is_complete(b)) return mantel_of_complete(a, b, params);
    return permutation_test(a.size, params, [&](std::span<const std::size_t> order) {
        return spearman(a.condensed, reordered(b, order)) >= observed - 1e-12;
    });
}

Interval bootstrap_interval(const Dissimilarity& a, const Dissimilarity& b,
                            const BootstrapParams& params) {
    assert(a.size == b.size && "matrices of the same objects");
    return interval_by_draws(a.size, params, [&](std::span<const std::size_t> drawn) {
        return spearman(reordered(a, drawn), reordered(b, drawn));
    });
}

Interval partial_bootstrap_interval(const Dissimilarity& a, const Dissimilarity& b,
                                    const Dissimilarity& given, const BootstrapParams& params) {
    assert(a.size == b.size && a.size == given.size && "matrices of the same objects");
    return interval_by_draws(a.size, params, [&](std::span<const std::size_t> drawn) {
        return partial_spearman(reordered(a, drawn), reordered(b, drawn), reordered(given, drawn));
    });
}

}  // namespace tact
