// The sets of k objects with the largest sums of distances, among all or among cliques of a graph.
//
// Source    branch and bound; the bounds are those of model/subset/concave_bound.h, and colours of
// the graph
//           (model/subset/clique.h). A candidate whose taking or leaving lowers the bound below the
//           worst set kept is left or taken for good.
// Exact     ties go to the lowest indices; same sets for any number of threads.
// Left out  bounds by semidefinite programs, which are tighter and slower.
#pragma once

#include <atomic>
#include <cstddef>
#include <functional>
#include <limits>
#include <mutex>
#include <span>
#include <vector>

#include "model/subset/clique.h"
#include "model/subset/search_limit.h"
#include "model/subset/whole_distances.h"

namespace tact {

struct HeavySet {
    Units sum = 0;
    std::vector<std::size_t> members;  // ascending

    bool operator==(const HeavySet&) const = default;
};

// Larger sums first, then lower indices.
bool is_better(const HeavySet& a, const HeavySet& b);

HeavySet heavy_set(const WholeDistances& distances, std::vector<std::size_t> members);

// The best sets of those offered so far, from any thread.
class BestSets {
  public:
    explicit BestSets(std::size_t capacity) : capacity_(capacity) {}

    void offer(const HeavySet& set);
    std::vector<HeavySet> sets() const;  // the best first

    // No set of a lower sum would be kept.
    Units floor() const { return floor_; }
    // Whether a set of that sum might still be kept whose members are not lower than these.
    bool would_keep(Units sum, std::span<const std::size_t> lowest) const;

  private:
    std::size_t capacity_;
    mutable std::mutex mutex_;
    std::vector<HeavySet> sets_;
    std::atomic<Units> floor_ = std::numeric_limits<Units>::min() / 4;
};

struct HeaviestProblem {
    const WholeDistances& distances;
    const Eigen::MatrixXd& real;          // the same
    const Graph* graph = nullptr;         // null: any two may stand together
    std::size_t count = 0;                // k
    std::span<const std::size_t> kept;    // in every set; a clique
    std::span<const std::size_t> others;  // to choose from
};

struct HeaviestRun {
    bool is_complete = true;  // else the limit was reached ...
    Units bound = 0;          // ... and no set left out has a sum above this
};

// What is told of a search, at once and under way, from any thread: how much is done, 0..1, and a
// sum that no set exceeds which is left to be looked at or kept.
using HeaviestTold = std::function<void(double share, Units bound)>;

// Offers sets to `best` until it holds the best of all.
HeaviestRun find_heaviest(const HeaviestProblem& problem, BestSets& best, const SearchLimit& limit,
                          int threads, const HeaviestTold& told = {});

}  // namespace tact
