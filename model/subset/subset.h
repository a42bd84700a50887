// The k most distinct of n objects, proven: what to pick so that nobody confuses them.
//
// Source    max-min and max-sum dispersion: Kuby 1987; Erkut 1990. See model/subset/widest_set.h
//           and model/subset/heaviest_sets.h for the searches.
// Input     dissimilarities of any kind; pairs that are no numbers (not rated) count as 0
// Output    the best subset, what is proven of it, and the next best ones
// Exact     what is called optimal is the same on any number of threads: ties of the objective go
//           to the larger sum, then to the lowest indices, all compared as whole numbers.
// Left out  other measures of spread, such as the sum of nearest neighbours.
#pragma once

#include <cstddef>
#include <functional>
#include <limits>
#include <stop_token>
#include <utility>
#include <vector>

#include "model/common/expected.h"
#include "model/dissimilarity/dissimilarity.h"
#include "model/subset/subset_start.h"

namespace tact {

struct SubsetProblem {
    std::size_t count = 0;  // k, at least 2
    SubsetObjective objective = SubsetObjective::max_min;
    std::vector<std::size_t> keep{};  // must be in it
    std::vector<std::size_t> drop{};  // must not

    bool operator==(const SubsetProblem&) const = default;
};

struct Subset {
    std::vector<std::size_t> members;               // ascending
    std::pair<std::size_t, std::size_t> weakest{};  // the least dissimilar two, the first of them
    double weakest_dissimilarity = 0.0;
    double sum = 0.0;  // of all its pairs

    bool operator==(const Subset&) const = default;
};

enum class SubsetProof {
    optimal,    // no other is better, nor as good with lower indices
    ties_open,  // max-min: no weakest pair is farther apart; the sum might be larger
    open        // a better one may exist, up to the bound
};

struct SubsetAnswer {
    Subset best;
    SubsetProof proof = SubsetProof::open;
    double bound = 0.0;                // no subset's objective is above it
    std::vector<Subset> alternatives;  // the next best in the order of the objective
    bool are_alternatives_proven = false;

    bool operator==(const SubsetAnswer&) const = default;
};

// What an objective counts of a subset.
inline double worth_of(const Subset& subset, SubsetObjective objective) {
    return objective == SubsetObjective::max_sum ? subset.sum : subset.weakest_dissimilarity;
}

struct SubsetOptions {
    double time_limit_s = std::numeric_limits<double>::infinity();
    std::size_t alternatives = 0;
    int threads = 0;  // 0: all cores
    std::stop_token stop{};
    std::function<void(double)> progress{};  // 0..1, from any thread; of the time limit, if nearer
    // The best subset so far and what no subset exceeds, told at once and as they come closer; from
    // any thread, before progress is told. Its proof is open. The last digits of the bound may be
    // rounded up.
    std::function<void(const SubsetAnswer&)> so_far{};
};

// An Error where no subset of n objects can be as asked.
Expected<Done> check_subset(const SubsetProblem& problem, std::size_t objects);

// At a stop or past the time limit: the best so far and a bound, not called optimal.
Expected<SubsetAnswer> most_distinct_subset(const Dissimilarity& dissimilarity,
                                            const SubsetProblem& problem,
                                            const SubsetOptions& options = {});

// The subset of these members.
Subset subset_of(const Dissimilarity& dissimilarity, std::vector<std::size_t> members);

// How far apart the weakest pair can be, for each k.
struct CurvePoint {
    std::size_t count = 0;
    double weakest = 0.0;
    double bound = 0.0;  // larger only where the proof was cut off

    bool operator==(const CurvePoint&) const = default;
};

// From the smallest possible k to `most`, or as many as there are. Keeps and drops as the problem
// does; its count and objective are ignored. The time limit is for all.
std::vector<CurvePoint> weakest_by_count(const Dissimilarity& dissimilarity,
                                         const SubsetProblem& problem, std::size_t most,
                                         const SubsetOptions& options = {});

}  // namespace tact
