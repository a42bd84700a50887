#include "model/map/group_tree.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace tact {

namespace {

// Two branches, each by its first object.
struct RawJoin {
    std::size_t into = 0;
    std::size_t from = 0;
    double height = 0.0;
};

// Branches under way: a square matrix of summed dissimilarities, and how many objects each has. As
// sums are kept and not means, rounding never makes a join lower than those within it, as long as
// the sums are exact.
class Linkage {
  public:
    explicit Linkage(const Dissimilarity& dissimilarity)
        : size_(dissimilarity.size),
          sum_(size_ * size_, 0.0),
          objects_(size_, 1.0),
          height_(size_, 0.0),
          left_(size_) {
        std::iota(left_.begin(), left_.end(), std::size_t{0});
        double largest = 0.0;
        for (const double value : dissimilarity.condensed) {
            if (std::isfinite(value)) largest = std::max(largest, value);
        }
        std::size_t k = 0;
        for (std::size_t i = 0; i < size_; ++i) {
            for (std::size_t j = i + 1; j < size_; ++j, ++k) {
                const double value = dissimilarity.condensed[k];
                set(i, j, std::isfinite(value) ? value : largest);
            }
        }
    }

    // All joins. A chain of nearest neighbours ends at two that are each other's nearest: they are
    // joined in the end in any case, as joining others never brings one closer.
    std::vector<RawJoin> joined() {
        std::vector<RawJoin> joins;
        std::vector<std::size_t> chain;
        while (left_.size() > 1) {
            if (chain.empty()) chain.push_back(left_.front());
            const std::size_t last = chain.back();
            const std::size_t before = chain.size() > 1 ? chain[chain.size() - 2] : size_;
            const std::size_t next = nearest(last, before);
            if (next != before) {
                chain.push_back(next);
                continue;
            }
            chain.resize(chain.size() - 2);
            const auto [into, from] = std::minmax(last, next);
            joins.push_back(join(into, from));
        }
        return joins;
    }

  private:
    double mean(std::size_t i, std::size_t j) const {
        return sum_[i * size_ + j] / (objects_[i] * objects_[j]);
    }
    void set(std::size_t i, std::size_t j, double value) {
        sum_[i * size_ + j] = value;
        sum_[j * size_ + i] = value;
    }

    // Ties: the one that the chain came from, then the first, so that chains end.
    std::size_t nearest(std::size_t i, std::size_t preferred) const {
        std::size_t best = preferred;
        double least =
            preferred == size_ ? std::numeric_limits<double>::infinity() : mean(i, preferred);
        for (const std::size_t j : left_) {
            if (j == i) continue;
            const double apart = mean(i, j);
            if (best != size_ && !(apart < least)) continue;
            best = j;
            least = apart;
        }
        return best;
    }

    RawJoin join(std::size_t into, std::size_t from) {
        const double height = std::max({mean(into, from), height_[into], height_[from]});
        std::erase(left_, from);
        for (const std::size_t j : left_) {
            if (j != into) set(into, j, sum_[into * size_ + j] + sum_[from * size_ + j]);
        }
        objects_[into] += objects_[from];
        height_[into] = height;
        return {into, from, height};
    }

    std::size_t size_;
    std::vector<double> sum_;
    std::vector<double> objects_;
    std::vector<double> height_;
    std::vector<std::size_t> left_;  // ascending
};

}  // namespace

GroupTree group_tree(const Dissimilarity& dissimilarity) {
    const std::size_t n = dissimilarity.size;
    std::vector<RawJoin> raw = Linkage(dissimilarity).joined();
    // A branch comes out before those that hold it, and stays so among equal heights.
    std::ranges::stable_sort(raw, {}, &RawJoin::height);
    GroupTree tree{n, {}};
    std::vector<std::size_t> branch(n);  // that begins with this object now
    std::iota(branch.begin(), branch.end(), std::size_t{0});
    const auto objects_in = [&tree, n](std::size_t k) {
        return k < n ? 1 : tree.joins[k - n].objects;
    };
    for (const RawJoin& join : raw) {
        const std::size_t a = branch[join.into];
        const std::size_t b = branch[join.from];
        branch[join.into] = n + tree.joins.size();
        tree.joins.push_back({a, b, join.height, objects_in(a) + objects_in(b)});
    }
    return tree;
}

std::size_t group_count(const GroupTree& tree, double cut) {
    const auto above = std::ranges::upper_bound(tree.joins, cut, {}, &GroupJoin::height);
    return tree.size - static_cast<std::size_t>(above - tree.joins.begin());
}

std::pair<double, double> cuts_of(const GroupTree& tree, std::size_t count) {
    const std::size_t held = tree.size - std::min(std::max<std::size_t>(count, 1), tree.size);
    const double from = held == 0 || tree.joins.empty() ? 0.0 : tree.joins[held - 1].height;
    const auto above = std::ranges::upper_bound(tree.joins, from, {}, &GroupJoin::height);
    const bool is_last = above == tree.joins.end();
    return {from, is_last ? std::numeric_limits<double>::infinity() : above->height};
}

std::vector<std::size_t> clusters(const GroupTree& tree, std::size_t count) {
    const std::size_t n = tree.size;
    if (n == 0) return {};
    const std::size_t held = n - std::min(std::max<std::size_t>(count, 1), n);
    // From the top down each branch hands its group on; objects come first in the numbering.
    std::vector<std::size_t> group(n + tree.joins.size());
    std::iota(group.begin(), group.end(), std::size_t{0});
    for (std::size_t k = held; k-- > 0;) {
        group[tree.joins[k].a] = group[tree.joins[k].b] = group[n + k];
    }
    std::vector<std::size_t> number(group.size(), n);  // n: not seen yet
    std::size_t seen = 0;
    for (std::size_t i = 0; i < n; ++i) {
        std::size_t& own = number[group[i]];
        if (own == n) own = seen++;
        group[i] = own;
    }
    group.resize(n);
    return group;
}

std::vector<std::size_t> clustered_order(const GroupTree& tree) {
    std::vector<std::size_t> order;
    std::vector<std::size_t> waiting;
    if (tree.size > 0) waiting.push_back(tree.size + tree.joins.size() - 1);
    while (!waiting.empty()) {
        const std::size_t branch = waiting.back();
        waiting.pop_back();
        if (branch < tree.size) {
            order.push_back(branch);
            continue;
        }
        const GroupJoin& join = tree.joins[branch - tree.size];
        waiting.push_back(join.b);
        waiting.push_back(join.a);
    }
    return order;
}

Dissimilarity joined_at(const GroupTree& tree) {
    const std::size_t n = tree.size;
    Dissimilarity result{n, std::vector<double>(pair_count(n), 0.0)};
    std::vector<std::vector<std::size_t>> objects(n + tree.joins.size());
    for (std::size_t i = 0; i < n; ++i) objects[i] = {i};
    for (std::size_t k = 0; k < tree.joins.size(); ++k) {
        const GroupJoin& join = tree.joins[k];
        for (const std::size_t i : objects[join.a]) {
            for (const std::size_t j : objects[join.b]) {
                const auto [first, second] = std::minmax(i, j);
                result.condensed[pair_index(n, first, second)] = join.height;
            }
        }
        std::vector<std::size_t>& all = objects[n + k];
        all = std::move(objects[join.a]);
        all.insert(all.end(), objects[join.b].begin(), objects[join.b].end());
        objects[join.b] = {};
    }
    return result;
}

std::size_t most_central(const Dissimilarity& dissimilarity, std::span<const std::size_t> members) {
    std::size_t best = members.front();
    double least = std::numeric_limits<double>::infinity();
    for (const std::size_t i : members) {
        double sum = 0.0;
        for (const std::size_t j : members) sum += dissimilarity(i, j);
        if (!(sum < least)) continue;
        least = sum;
        best = i;
    }
    return best;
}

}  // namespace tact
