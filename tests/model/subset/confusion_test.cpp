#include "model/subset/confusion.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace confusion_test {

using namespace tact;

namespace {

using Places = std::vector<std::size_t>;

// Objects on a line.
Dissimilarity on_a_line(const std::vector<double>& at) {
    Dissimilarity result{at.size(), {}};
    for (std::size_t i = 0; i < at.size(); ++i) {
        for (std::size_t j = i + 1; j < at.size(); ++j) {
            result.condensed.push_back(std::abs(at[j] - at[i]));
        }
    }
    return result;
}

std::vector<Places> members_of(const Confusion& confusion) {
    std::vector<Places> all;
    for (const ConfusedGroup& group : confusion.groups) all.push_back(group.members);
    return all;
}

// Two are in one group if steps below the threshold lead from one to the other: by Warshall.
std::vector<std::vector<bool>> reachable(const Dissimilarity& d, double threshold) {
    std::vector<std::vector<bool>> reach(d.size, std::vector<bool>(d.size, false));
    for (std::size_t i = 0; i < d.size; ++i) {
        for (std::size_t j = 0; j < d.size; ++j) reach[i][j] = i == j || d(i, j) < threshold;
    }
    for (std::size_t k = 0; k < d.size; ++k) {
        for (std::size_t i = 0; i < d.size; ++i) {
            for (std::size_t j = 0; j < d.size; ++j) {
                if (reach[i][k] && reach[k][j]) reach[i][j] = true;
            }
        }
    }
    return reach;
}

}  // namespace

TEST_CASE("confusion: chains below the threshold are groups, and their ends may be far apart") {
    const Confusion found = confusion(on_a_line({10.0, 0.0, 1.0, 2.0, 10.5, 20.0}), {1.5, 0.6});
    CHECK((members_of(found) == std::vector<Places>{{1, 2, 3}, {0, 4}}));
    CHECK((found.groups[0].closest == ConfusablePair{1, 2, 1.0}));
    CHECK((found.groups[0].farthest == ConfusablePair{1, 3, 2.0}));
    CHECK(found.confused_pairs == 3);
    CHECK((found.links == std::vector<ConfusablePair>{{0, 4, 0.5}, {1, 2, 1.0}, {2, 3, 1.0}}));
    CHECK(distinct_count(found) == 3);
    const Places nearest{4, 2, 1, 2, 0, 4};
    for (std::size_t i = 0; i < nearest.size(); ++i) CHECK(found.nearest[i].place == nearest[i]);
    CHECK(found.nearest[0].verdict == ConfusionVerdict::same);
    CHECK(found.nearest[1].verdict == ConfusionVerdict::hard_to_tell);
    CHECK(found.nearest[5].verdict == ConfusionVerdict::clear);
    CHECK(found.nearest[5].dissimilarity == 9.5);
}

TEST_CASE("confusion: a pair at a threshold is not below it, so a subset's weakest pair is clear") {
    const Dissimilarity d = on_a_line({0.0, 4.0, 8.0});
    CHECK(confusion(d, {4.0, 2.0}).groups.empty());
    CHECK(confusion(d, {4.0, 4.0}).nearest[0].verdict == ConfusionVerdict::clear);
    CHECK(confusion(d, {std::nextafter(4.0, 5.0), 4.0}).groups.size() == 1);
    CHECK(confusion(d, {5.0, 4.0}).nearest[0].verdict == ConfusionVerdict::hard_to_tell);
}

TEST_CASE("confusion: groups are what can be reached, whatever the order of the objects") {
    std::uint64_t state = 7;
    const auto next = [&state] {
        state = state * 6364136223846793005U + 1442695040888963407U;
        return static_cast<double>(state >> 33U) / 2147483648.0;
    };
    for (int round = 0; round < 50; ++round) {
        std::vector<double> at(12);
        for (double& one : at) one = 10.0 * next();
        const double threshold = 0.2 + next();
        const Dissimilarity d = on_a_line(at);
        const Confusion found = confusion(d, {threshold, 0.0});
        const auto reach = reachable(d, threshold);
        CHECK(found.links.size() == at.size() - distinct_count(found));
        std::vector<std::size_t> group_of(at.size());
        for (std::size_t i = 0; i < at.size(); ++i) group_of[i] = 100 + i;  // by itself
        for (std::size_t g = 0; g < found.groups.size(); ++g) {
            CHECK(std::ranges::is_sorted(found.groups[g].members));
            for (const std::size_t i : found.groups[g].members) group_of[i] = g;
        }
        for (std::size_t i = 0; i < at.size(); ++i) {
            for (std::size_t j = 0; j < at.size(); ++j) {
                CHECK((group_of[i] == group_of[j]) == reach[i][j]);
            }
        }
    }
}

TEST_CASE("confusion: a higher threshold only ever joins, until all is one group") {
    const Dissimilarity d = on_a_line({0.0, 1.0, 3.0, 6.0, 10.0, 15.0});
    std::size_t before = 6;
    for (double threshold = 0.5; threshold < 7.0; threshold += 0.5) {
        const std::size_t now = distinct_count(confusion(d, {threshold, 0.0}));
        CHECK(now <= before);
        before = now;
    }
    CHECK(before == 1);
}

TEST_CASE("confusion: pairs that nobody rated join nothing, and nothing is nobody's neighbour") {
    constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
    const Confusion found = confusion({3, {kNone, kNone, 1.0}}, {2.0, 0.0});
    CHECK((members_of(found) == std::vector<Places>{{1, 2}}));
    CHECK(std::isinf(found.nearest[0].dissimilarity));
    CHECK(found.nearest[0].verdict == ConfusionVerdict::clear);
    CHECK(confusion({0, {}}, {1.0, 0.5}).groups.empty());
    CHECK(distinct_count(confusion({1, {}}, {1.0, 0.5})) == 1);
}

}  // namespace confusion_test
