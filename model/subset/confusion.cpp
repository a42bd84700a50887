#include "model/subset/confusion.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <numeric>

namespace tact {

namespace {

// Objects joined into groups: each knows one that came before it, or is the first of its group.
struct Joined {
    std::vector<std::size_t> before;

    explicit Joined(std::size_t count) : before(count) {
        std::iota(before.begin(), before.end(), std::size_t{0});
    }

    std::size_t first_of(std::size_t i) {
        while (before[i] != i) {
            before[i] = before[before[i]];  // the way is half as long next time
            i = before[i];
        }
        return i;
    }

    // False: they are one group already.
    bool join(std::size_t i, std::size_t j) {
        i = first_of(i);
        j = first_of(j);
        before[std::max(i, j)] = std::min(i, j);
        return i != j;
    }
};

// Both ends of what is apart within a group; `members` has two at least.
void measure(ConfusedGroup& group, const Dissimilarity& dissimilarity) {
    group.closest.dissimilarity = std::numeric_limits<double>::infinity();
    group.farthest.dissimilarity = -std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < group.members.size(); ++i) {
        for (std::size_t j = i + 1; j < group.members.size(); ++j) {
            const ConfusablePair pair{group.members[i], group.members[j],
                                      dissimilarity(group.members[i], group.members[j])};
            if (!std::isfinite(pair.dissimilarity)) continue;
            if (pair.dissimilarity < group.closest.dissimilarity) group.closest = pair;
            if (pair.dissimilarity > group.farthest.dissimilarity) group.farthest = pair;
        }
    }
}

std::vector<ConfusedGroup> groups_of(Joined joined, const Dissimilarity& dissimilarity) {
    std::vector<ConfusedGroup> by_first(dissimilarity.size);
    for (std::size_t i = 0; i < dissimilarity.size; ++i) {
        by_first[joined.first_of(i)].members.push_back(i);
    }
    std::erase_if(by_first, [](const ConfusedGroup& group) { return group.members.size() < 2; });
    std::ranges::stable_sort(by_first, [](const ConfusedGroup& a, const ConfusedGroup& b) {
        return a.members.size() > b.members.size();
    });
    for (ConfusedGroup& group : by_first) measure(group, dissimilarity);
    return by_first;
}

}  // namespace

ConfusionVerdict verdict_of(double dissimilarity, const ConfusionThresholds& thresholds) {
    if (dissimilarity < thresholds.same) return ConfusionVerdict::same;
    if (dissimilarity < thresholds.confused) return ConfusionVerdict::hard_to_tell;
    return ConfusionVerdict::clear;
}

Confusion confusion(const Dissimilarity& dissimilarity, const ConfusionThresholds& thresholds) {
    assert(thresholds.same <= thresholds.confused && "what is the same is confused");
    const std::size_t n = dissimilarity.size;
    Confusion result{thresholds, {}, {}, {}, 0};
    for (std::size_t i = 0; i < n; ++i) {
        result.nearest.push_back({i, std::numeric_limits<double>::infinity()});
    }
    std::vector<ConfusablePair> confused;
    const auto look = [&](std::size_t i, std::size_t j, double apart) {
        if (apart < result.nearest[i].dissimilarity) result.nearest[i] = {j, apart};
    };
    for (std::size_t k = 0; k < dissimilarity.condensed.size(); ++k) {
        const double apart = dissimilarity.condensed[k];
        if (!std::isfinite(apart)) continue;
        const auto [i, j] = pair_at(n, k);
        look(i, j, apart);
        look(j, i, apart);
        if (!(apart < thresholds.confused)) continue;
        confused.push_back({i, j, apart});
    }
    result.confused_pairs = confused.size();
    std::ranges::stable_sort(confused, {}, &ConfusablePair::dissimilarity);
    Joined joined(n);
    for (const ConfusablePair& pair : confused) {
        if (joined.join(pair.a, pair.b)) result.links.push_back(pair);
    }
    for (NearestNeighbour& nearest : result.nearest) {
        nearest.verdict = verdict_of(nearest.dissimilarity, thresholds);
    }
    result.groups = groups_of(std::move(joined), dissimilarity);
    return result;
}

std::size_t distinct_count(const Confusion& confusion) {
    std::size_t count = confusion.nearest.size();
    for (const ConfusedGroup& group : confusion.groups) count -= group.members.size() - 1;
    return count;
}

}  // namespace tact
