// Trees of groups against SciPy, and laws that hold for any.
//
// The numbers are SciPy 1.10.1's:
//   python3 -c "from scipy.cluster.hierarchy import *
//   n = 9; d = [(7*i*i + 13*j*j + 5*i*j) % 101 + i/8 + j/64 for i in range(n) for j in range(i+1,
//   n)] Z = average(d); print(Z, fcluster(Z, 4, 'maxclust'), fcluster(Z, 40, 'distance'),
//   cophenet(Z)[:8])"
#include "model/map/group_tree.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "model/common/random.h"

namespace group_tree_test {

using namespace tact;

namespace {

Dissimilarity of_scipy() {
    constexpr std::size_t kObjects = 9;
    Dissimilarity d{kObjects, {}};
    for (std::size_t i = 0; i < kObjects; ++i) {
        for (std::size_t j = i + 1; j < kObjects; ++j) {
            d.condensed.push_back(static_cast<double>((7 * i * i + 13 * j * j + 5 * i * j) % 101) +
                                  static_cast<double>(i) / 8.0 + static_cast<double>(j) / 64.0);
        }
    }
    return d;
}

// Ranks of pairs, as PM has them: all different, and their sums are exact.
Dissimilarity ranked(std::size_t n, std::uint64_t seed) {
    RandomStream random{seed};
    Dissimilarity d{n, std::vector<double>(pair_count(n))};
    for (double& value : d.condensed) value = next_even(random);
    d.condensed = average_ranks(d.condensed);
    return d;
}

Dissimilarity on_a_line(const std::vector<double>& x) {
    Dissimilarity d{x.size(), {}};
    for (std::size_t i = 0; i < x.size(); ++i) {
        for (std::size_t j = i + 1; j < x.size(); ++j) d.condensed.push_back(std::abs(x[i] - x[j]));
    }
    return d;
}

// Whether two sortings into groups are the same but for the groups' numbers.
bool same_groups(const std::vector<std::size_t>& a, const std::vector<std::size_t>& b) {
    for (std::size_t i = 0; i < a.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
            if ((a[i] == a[j]) != (b[i] == b[j])) return false;
        }
    }
    return a.size() == b.size();
}

double mean_between(const Dissimilarity& d, const std::vector<std::size_t>& group, std::size_t a,
                    std::size_t b) {
    double sum = 0.0;
    double pairs = 0.0;
    for (std::size_t i = 0; i < d.size; ++i) {
        for (std::size_t j = 0; j < d.size; ++j) {
            if (group[i] != a || group[j] != b) continue;
            sum += d(i, j);
            pairs += 1.0;
        }
    }
    return sum / pairs;
}

}  // namespace

TEST_CASE("group tree: joins, cuts and heights of pairs are SciPy's") {
    const Dissimilarity d = of_scipy();
    const GroupTree tree = group_tree(d);
    const std::vector<GroupJoin> expected{{1, 6, 0.21875, 2},   {3, 8, 5.5, 2},
                                          {0, 4, 6.0625, 2},    {11, 5, 27.328125, 3},
                                          {2, 7, 28.359375, 2}, {9, 10, 34.19140625, 4},
                                          {12, 14, 55.4375, 7}, {15, 13, 67.705357142857139, 9}};
    REQUIRE(tree.joins.size() == expected.size());
    for (std::size_t k = 0; k < expected.size(); ++k) {
        CAPTURE(k);
        // The branch with the first object stands first; SciPy has the lower number first.
        CHECK(std::minmax(tree.joins[k].a, tree.joins[k].b) ==
              std::minmax(expected[k].a, expected[k].b));
        // Means that are taken in another order may differ in their last bits.
        CHECK(std::abs(tree.joins[k].height - expected[k].height) <= 1e-12);
        CHECK(tree.joins[k].objects == expected[k].objects);
    }
    CHECK(same_groups(clusters(tree, 4), {2, 3, 1, 4, 2, 2, 3, 1, 4}));
    CHECK(group_count(tree, 40.0) == 3);
    CHECK(same_groups(clusters(tree, 3), {2, 3, 1, 3, 2, 2, 3, 1, 3}));
    const std::vector<double> first_row{55.4375, 67.705357142857139, 55.4375, 6.0625, 27.328125,
                                        55.4375, 67.705357142857139, 55.4375};
    const Dissimilarity joined = joined_at(tree);
    for (std::size_t j = 1; j < d.size; ++j) {
        CHECK(std::abs(joined(0, j) - first_row[j - 1]) <= 1e-12);
    }
}

TEST_CASE("group tree: a height is the mean of the pairs between both branches, and none falls") {
    for (const std::uint64_t seed : {1U, 2U, 3U}) {
        const Dissimilarity d = ranked(60, seed);
        const GroupTree tree = group_tree(d);
        REQUIRE(tree.joins.size() == 59);
        CHECK(std::ranges::is_sorted(tree.joins, {}, &GroupJoin::height));
        CHECK(tree.joins.back().objects == 60);
        for (std::size_t groups = 1; groups < 60; ++groups) {
            // What the next join brings together.
            const std::vector<std::size_t> before = clusters(tree, groups + 1);
            const std::vector<std::size_t> after = clusters(tree, groups);
            std::size_t a = 60;
            std::size_t b = 60;
            for (std::size_t i = 0; i < 60; ++i) {
                for (std::size_t j = 0; j < i; ++j) {
                    if (after[i] != after[j] || before[i] == before[j]) continue;
                    a = before[j];
                    b = before[i];
                }
            }
            REQUIRE(a < 60);
            CHECK(mean_between(d, before, a, b) == tree.joins[59 - groups].height);
            // No two groups that are left are closer: it was the next one.
            for (std::size_t c = 0; c <= groups; ++c) {
                for (std::size_t e = 0; e < c; ++e) {
                    CHECK(mean_between(d, before, e, c) >= tree.joins[59 - groups].height);
                }
            }
        }
    }
}

TEST_CASE("group tree: objects in another order have the same tree") {
    const std::size_t n = 80;
    const Dissimilarity d = ranked(n, 7);
    std::vector<std::size_t> order(n);
    std::iota(order.begin(), order.end(), std::size_t{0});
    RandomStream random{11};
    for (std::size_t k = n; k-- > 1;) {
        const double share = 0.5 * (next_even(random) + 1.0);
        std::swap(order[k],
                  order[std::min(k, static_cast<std::size_t>(share * static_cast<double>(k + 1)))]);
    }
    Dissimilarity turned{n, {}};
    for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t j = i + 1; j < n; ++j) turned.condensed.push_back(d(order[i], order[j]));
    }
    const Dissimilarity here = joined_at(group_tree(d));
    const Dissimilarity there = joined_at(group_tree(turned));
    for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t j = 0; j < i; ++j) CHECK(there(i, j) == here(order[i], order[j]));
    }
}

TEST_CASE("group tree: heights of pairs are ultrametric, and a cut parts those above it") {
    const Dissimilarity d = ranked(40, 5);
    const GroupTree tree = group_tree(d);
    const Dissimilarity joined = joined_at(tree);
    for (std::size_t i = 0; i < 40; ++i) {
        for (std::size_t j = 0; j < 40; ++j) {
            for (std::size_t k = 0; k < 40; ++k) {
                CHECK(joined(i, j) <= std::max(joined(i, k), joined(k, j)));
            }
        }
    }
    for (std::size_t count = 1; count <= 40; ++count) {
        const auto [from, below] = cuts_of(tree, count);
        CHECK(group_count(tree, from) == count);
        if (std::isfinite(below)) CHECK(group_count(tree, below) < count);
        const std::vector<std::size_t> group = clusters(tree, count);
        for (std::size_t i = 0; i < 40; ++i) {
            for (std::size_t j = 0; j < i; ++j) {
                CHECK((group[i] == group[j]) == (joined(i, j) <= from));
            }
        }
    }
}

TEST_CASE("group tree: leaves of a group stand side by side, the first object at the left") {
    const GroupTree tree = group_tree(ranked(50, 9));
    const std::vector<std::size_t> order = clustered_order(tree);
    CHECK(order.front() == 0);
    for (const std::size_t count : {1U, 3U, 10U, 50U}) {
        const std::vector<std::size_t> group = clusters(tree, count);
        std::size_t runs = 1;
        for (std::size_t k = 1; k < order.size(); ++k)
            runs += group[order[k]] != group[order[k - 1]];
        CHECK(runs == count);
    }
}

TEST_CASE("group tree: equal distances, unknown ones, and hardly any objects") {
    CHECK(group_tree({0, {}}).joins.empty());
    CHECK(clusters(group_tree({0, {}}), 2).empty());
    CHECK(clustered_order(group_tree({0, {}})).empty());
    CHECK(clusters(group_tree({1, {}}), 2) == std::vector<std::size_t>{0});
    CHECK(clustered_order(group_tree({1, {}})) == std::vector<std::size_t>{0});
    const GroupTree equal = group_tree({5, std::vector<double>(10, 2.0)});
    for (const GroupJoin& join : equal.joins) CHECK(join.height == 2.0);
    CHECK(group_count(equal, 1.9) == 5);
    CHECK(group_count(equal, 2.0) == 1);
    CHECK(clusters(equal, 3) == clusters(group_tree({5, std::vector<double>(10, 2.0)}), 3));
    // What is not known is as far as the farthest.
    const double unknown = std::numeric_limits<double>::infinity();
    CHECK(clusters(group_tree({3, {1.0, unknown, 3.0}}), 2) == std::vector<std::size_t>{0, 0, 1});
}

TEST_CASE("group tree: near ones together, numbered by their first; as many as asked for") {
    const GroupTree tree = group_tree(on_a_line({0.0, 10.0, 0.1, 10.2, 20.0}));
    CHECK(clusters(tree, 3) == std::vector<std::size_t>{0, 1, 0, 1, 2});
    CHECK(clusters(tree, 1) == std::vector<std::size_t>(5, 0));
    CHECK(clusters(tree, 9) == std::vector<std::size_t>{0, 1, 2, 3, 4});
    // Single linkage would join the first three: 0 0 0 1.
    CHECK(clusters(group_tree(on_a_line({0.0, 1.0, 2.6, 4.4})), 2) ==
          std::vector<std::size_t>{0, 0, 1, 1});
}

TEST_CASE("group tree: the most central is the one closest to all of its group") {
    const Dissimilarity line = on_a_line({0.0, 1.0, 2.0, 10.0, 11.0});
    CHECK(most_central(line, std::vector<std::size_t>{0, 1, 2}) == 1);
    CHECK(most_central(line, std::vector<std::size_t>{3, 4}) == 3);  // equal: the first
    CHECK(most_central(line, std::vector<std::size_t>{4}) == 4);
}

}  // namespace group_tree_test
