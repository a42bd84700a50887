#include "model/subset/subset_start.h"

#include <algorithm>
#include <cassert>
#include <limits>

namespace tact {

namespace {

constexpr std::size_t kStarts = 24;

// How good a subset is: its weakest pair, then its sum; or its sum alone.
struct Worth {
    Units first = std::numeric_limits<Units>::min();
    Units second = 0;

    auto operator<=>(const Worth&) const = default;
};

// What one object is to the members: its smallest distance and their sum.
struct Standing {
    Units least = std::numeric_limits<Units>::max();
    Units sum = 0;
};

class Start {
  public:
    Start(const WholeDistances& distances, SubsetObjective objective,
          std::span<const std::size_t> kept, std::span<const std::size_t> others)
        : distances_(distances), objective_(objective), kept_(kept), others_(others) {}

    std::vector<std::size_t> grown(std::size_t count, std::size_t first) const {
        std::vector<std::size_t> members(kept_.begin(), kept_.end());
        if (members.empty() && count > 0) members.push_back(first);
        std::vector<Standing> standing(distances_.size);
        for (const std::size_t member : members) add(standing, member);
        std::vector<char> is_member(distances_.size, 0);
        for (const std::size_t member : members) is_member[member] = 1;
        while (members.size() < count) {
            std::size_t best = distances_.size;
            for (const std::size_t v : others_) {
                if (is_member[v] != 0) continue;
                if (best == distances_.size || worth(standing[v]) > worth(standing[best])) best = v;
            }
            members.push_back(best);
            is_member[best] = 1;
            add(standing, best);
        }
        return members;
    }

    Worth worth_of(std::span<const std::size_t> members) const {
        Standing all;
        for (std::size_t i = 0; i < members.size(); ++i) {
            for (std::size_t j = i + 1; j < members.size(); ++j) {
                const Units distance = distances_(members[i], members[j]);
                all.least = std::min(all.least, distance);
                all.sum += distance;
            }
        }
        return worth(all);
    }

    // Exchanges one member for another object as long as that helps, the best exchange each time.
    void improve(std::vector<std::size_t>& members) const {
        for (Worth now = worth_of(members);;) {
            Worth best = now;
            std::size_t out = 0;
            std::size_t in = 0;
            for (std::size_t m = kept_.size(); m < members.size(); ++m) {
                const auto [worth, object] = best_instead_of(members, m);
                if (worth <= best) continue;
                best = worth;
                out = m;
                in = object;
            }
            if (best == now) return;
            members[out] = in;
            now = best;
        }
    }

  private:
    Worth worth(const Standing& standing) const {
        if (objective_ == SubsetObjective::max_sum) return {standing.sum, 0};
        return {standing.least, standing.sum};
    }

    void add(std::vector<Standing>& standing, std::size_t member) const {
        const Units* row = distances_.row(member);
        for (std::size_t v = 0; v < standing.size(); ++v) {
            standing[v].least = std::min(standing[v].least, row[v]);
            standing[v].sum += row[v];
        }
    }

    std::pair<Worth, std::size_t> best_instead_of(const std::vector<std::size_t>& members,
                                                  std::size_t place) const {
        std::vector<std::size_t> rest = members;
        rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(place));
        Standing within;
        std::vector<Standing> standing(distances_.size);
        for (const std::size_t member : rest) {
            within.least = std::min(within.least, standing[member].least);
            within.sum += standing[member].sum;
            add(standing, member);
        }
        std::pair<Worth, std::size_t> best;
        for (const std::size_t v : others_) {
            if (std::ranges::find(members, v) != members.end()) continue;
            const Worth with_v =
                worth({std::min(within.least, standing[v].least), within.sum + standing[v].sum});
            if (with_v > best.first) best = {with_v, v};
        }
        return best;
    }

    const WholeDistances& distances_;
    SubsetObjective objective_;
    std::span<const std::size_t> kept_;
    std::span<const std::size_t> others_;
};

}  // namespace

std::vector<std::size_t> started_subset(const WholeDistances& distances, SubsetObjective objective,
                                        std::size_t count, std::span<const std::size_t> kept,
                                        std::span<const std::size_t> others) {
    if (kept.size() + others.size() < count) return {};
    const Start start(distances, objective, kept, others);
    std::vector<std::size_t> best;
    Worth best_worth;
    // With something kept there is only one way to grow.
    const std::size_t starts = kept.empty() ? std::min(kStarts, others.size()) : 1;
    for (std::size_t s = 0; s < starts; ++s) {
        const std::size_t first = kept.empty() ? others[s * others.size() / starts] : kept.front();
        std::vector<std::size_t> members = start.grown(count, first);
        start.improve(members);
        const Worth worth = start.worth_of(members);
        if (!best.empty() && worth <= best_worth) continue;
        best = std::move(members);
        best_worth = worth;
    }
    std::ranges::sort(best);
    return best;
}

Units weakest_of(const WholeDistances& distances, std::span<const std::size_t> members) {
    Units weakest = std::numeric_limits<Units>::max();
    for (const std::size_t i : members) {
        for (const std::size_t j : members) {
            if (i < j) weakest = std::min(weakest, distances(i, j));
        }
    }
    return weakest;
}

}  // namespace tact
