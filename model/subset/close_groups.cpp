#include "model/subset/close_groups.h"

#include <algorithm>
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
void measure(CloseGroup& group, const Dissimilarity& dissimilarity) {
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

std::vector<CloseGroup> groups_of(Joined joined, const Dissimilarity& dissimilarity) {
    std::vector<CloseGroup> by_first(dissimilarity.size);
    for (std::size_t i = 0; i < dissimilarity.size; ++i) {
        by_first[joined.first_of(i)].members.push_back(i);
    }
    std::erase_if(by_first, [](const CloseGroup& group) { return group.members.size() < 2; });
    std::ranges::stable_sort(by_first, [](const CloseGroup& a, const CloseGroup& b) {
        return a.members.size() > b.members.size();
    });
    for (CloseGroup& group : by_first) measure(group, dissimilarity);
    return by_first;
}

// `pairs` count as close, in any order.
CloseGroups grouped(const Dissimilarity& dissimilarity, std::vector<ConfusablePair> pairs) {
    CloseGroups result;
    result.nearest = nearest_neighbours(dissimilarity);
    result.pairs = pairs.size();
    std::ranges::stable_sort(pairs, {}, &ConfusablePair::dissimilarity);
    Joined joined(dissimilarity.size);
    for (const ConfusablePair& pair : pairs) {
        if (joined.join(pair.a, pair.b)) result.links.push_back(pair);
    }
    result.groups = groups_of(std::move(joined), dissimilarity);
    return result;
}

}  // namespace

std::vector<NearestNeighbour> nearest_neighbours(const Dissimilarity& dissimilarity) {
    const std::size_t n = dissimilarity.size;
    std::vector<NearestNeighbour> nearest;
    for (std::size_t i = 0; i < n; ++i) {
        nearest.push_back({i, std::numeric_limits<double>::infinity()});
    }
    const auto look = [&nearest](std::size_t i, std::size_t j, double apart) {
        if (apart < nearest[i].dissimilarity) nearest[i] = {j, apart};
    };
    std::size_t k = 0;
    for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t j = i + 1; j < n; ++j, ++k) {
            const double apart = dissimilarity.condensed[k];
            if (!std::isfinite(apart)) continue;
            look(i, j, apart);
            look(j, i, apart);
        }
    }
    return nearest;
}

CloseGroups groups_below(const Dissimilarity& dissimilarity, double threshold) {
    std::vector<ConfusablePair> below;
    for (std::size_t k = 0; k < dissimilarity.condensed.size(); ++k) {
        const double apart = dissimilarity.condensed[k];
        const auto [i, j] = pair_at(dissimilarity.size, k);
        if (std::isfinite(apart) && apart < threshold) below.push_back({i, j, apart});
    }
    return grouped(dissimilarity, std::move(below));
}

CloseGroups groups_within_a_step(const PatternSet& set, const Dissimilarity& dissimilarity) {
    std::vector<ConfusablePair> pairs = pairs_within_a_step(set, dissimilarity);
    std::erase_if(pairs, [](const ConfusablePair& pair) {
        return !std::isfinite(pair.dissimilarity);  // not rated: it has no place in an order
    });
    return grouped(dissimilarity, std::move(pairs));
}

std::size_t distinct_count(const CloseGroups& close) {
    std::size_t count = close.nearest.size();
    for (const CloseGroup& group : close.groups) count -= group.members.size() - 1;
    return count;
}

}  // namespace tact
