// Which patterns of a set hang together: those within a felt step, which people would confuse, and
// those that are closer than some pair that somebody chose.
//
// Source    groups: single linkage, Florek et al. 1951, as far as a threshold; links: Kruskal 1956.
//           Two of a group may be far apart when others stand between them: its farthest pair says
//           so.
// Input     dissimilarities of any kind; pairs that are no numbers (not rated) are far apart
// Output    groups of two or more, the largest first, of equals the one with the lowest index
// Left out  how probable a confusion is: nobody has measured at which dissimilarity one begins.
// Exact     same input, same groups, on any number of threads.
#pragma once

#include <cstddef>
#include <vector>

#include "model/dissimilarity/dissimilarity.h"
#include "model/set/pattern_set.h"
#include "model/subset/confusable.h"

namespace tact {

struct NearestNeighbour {
    std::size_t place = 0;
    double dissimilarity = 0.0;  // infinite where no pair is a number; `place` is the object's own

    bool exists_for(std::size_t object) const { return place != object; }

    bool operator==(const NearestNeighbour&) const = default;
};

// The nearest other one of each object; equals are decided by the lowest index.
std::vector<NearestNeighbour> nearest_neighbours(const Dissimilarity& dissimilarity);

struct CloseGroup {
    std::vector<std::size_t> members;  // ascending
    ConfusablePair closest;
    ConfusablePair farthest;  // of the pairs that are numbers

    bool operator==(const CloseGroup&) const = default;
};

struct CloseGroups {
    std::vector<NearestNeighbour> nearest;  // of each object
    std::vector<CloseGroup> groups;
    std::vector<ConfusablePair> links;  // that hold groups together, one fewer than members each
    std::size_t pairs = 0;              // all that count as close

    bool operator==(const CloseGroups&) const = default;
};

// Pairs below the threshold count; those at it do not.
CloseGroups groups_below(const Dissimilarity& dissimilarity, double threshold);

// Pairs count of which no number differs by a felt step (within_a_step in confusable.h).
CloseGroups groups_within_a_step(const PatternSet& set, const Dissimilarity& dissimilarity);

// How many objects a person would tell apart if each group were one.
std::size_t distinct_count(const CloseGroups& close);

}  // namespace tact
