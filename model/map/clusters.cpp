#include "model/map/clusters.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace tact {

namespace {

struct Join {
    std::size_t a = 0;
    std::size_t b = 0;
    double height = 0.0;
};

// Groups under way: a square matrix of mean distances, and how many objects each stands for.
class Linkage {
  public:
    explicit Linkage(const Dissimilarity& dissimilarity)
        : size_(dissimilarity.size), distance_(size_ * size_, 0.0), weight_(size_, 1.0) {
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
    std::vector<Join> joined() {
        std::vector<Join> joins;
        std::vector<std::size_t> chain;
        while (joins.size() + 1 < size_) {
            if (chain.empty()) chain.push_back(first_left());
            const std::size_t last = chain.back();
            const std::size_t before = chain.size() > 1 ? chain[chain.size() - 2] : size_;
            const std::size_t next = nearest(last, before);
            if (next != before) {
                chain.push_back(next);
                continue;
            }
            chain.resize(chain.size() - 2);
            const auto [into, from] = std::minmax(last, next);
            joins.push_back({into, from, distance(into, from)});
            join(into, from);
        }
        return joins;
    }

  private:
    double distance(std::size_t i, std::size_t j) const { return distance_[i * size_ + j]; }
    void set(std::size_t i, std::size_t j, double value) {
        distance_[i * size_ + j] = value;
        distance_[j * size_ + i] = value;
    }

    std::size_t first_left() const {
        return static_cast<std::size_t>(
            std::ranges::find_if(weight_, [](double w) { return w > 0.0; }) - weight_.begin());
    }

    // Ties: the one that the chain came from, then the first, so that chains end.
    std::size_t nearest(std::size_t i, std::size_t preferred) const {
        std::size_t best = preferred;
        for (std::size_t j = 0; j < size_; ++j) {
            if (j == i || weight_[j] <= 0.0) continue;
            if (best == size_ || distance(i, j) < distance(i, best)) best = j;
        }
        return best;
    }

    void join(std::size_t into, std::size_t from) {
        const double all = weight_[into] + weight_[from];
        for (std::size_t j = 0; j < size_; ++j) {
            if (j == into || j == from || weight_[j] <= 0.0) continue;
            set(into, j,
                (weight_[into] * distance(into, j) + weight_[from] * distance(from, j)) / all);
        }
        weight_[into] = all;
        weight_[from] = 0.0;
    }

    std::size_t size_;
    std::vector<double> distance_;
    std::vector<double> weight_;
};

}  // namespace

std::vector<std::size_t> clusters(const Dissimilarity& dissimilarity, std::size_t count) {
    const std::size_t n = dissimilarity.size;
    std::vector<Join> joins = Linkage(dissimilarity).joined();
    std::ranges::stable_sort(joins, {}, &Join::height);
    // The lowest joins leave `count` groups; each is known by its first object.
    std::vector<std::size_t> first(n);
    std::iota(first.begin(), first.end(), std::size_t{0});
    const std::size_t wanted = std::max<std::size_t>(count, 1);
    for (std::size_t k = 0; k + wanted < n; ++k) {
        const auto [into, from] = std::minmax(first[joins[k].a], first[joins[k].b]);
        std::ranges::replace(first, std::size_t{from}, std::size_t{into});
    }
    std::vector<std::size_t> group(n, 0);
    std::vector<std::size_t> seen;
    for (std::size_t i = 0; i < n; ++i) {
        const auto found = std::ranges::find(seen, first[i]);
        group[i] = static_cast<std::size_t>(found - seen.begin());
        if (found == seen.end()) seen.push_back(first[i]);
    }
    return group;
}

std::vector<std::size_t> clustered_order(const Dissimilarity& dissimilarity) {
    std::vector<Join> joins = Linkage(dissimilarity).joined();
    std::ranges::stable_sort(joins, {}, &Join::height);
    // Each branch is kept under its first object, and known by all of its objects.
    std::vector<std::vector<std::size_t>> branch(dissimilarity.size);
    std::vector<std::size_t> first(dissimilarity.size);
    for (std::size_t k = 0; k < branch.size(); ++k) branch[k] = {first[k] = k};
    for (const Join& join : joins) {
        const auto [into, from] = std::minmax(first[join.a], first[join.b]);
        std::vector<std::size_t> moved = std::move(branch[from]);
        branch[from].clear();
        for (const std::size_t object : moved) first[object] = into;
        branch[into].insert(branch[into].end(), moved.begin(), moved.end());
    }
    return branch.empty() ? std::vector<std::size_t>{} : branch.front();
}

}  // namespace tact
