// Which patterns of a set people would confuse: groups that hang together, and each one's nearest.
//
// Source    groups: single linkage, Florek et al. 1951, as far as a threshold; links: Kruskal 1956.
// Two of a group may be
//           far apart when others stand between them: its farthest pair says so.
// Input     dissimilarities of any kind; pairs that are no numbers (not rated) are far apart
// Output    groups of two or more, the largest first, of equals the one with the lowest index
// Left out  how probable a confusion is: neither threshold is measured.
// Exact     same input, same groups, on any number of threads.
#pragma once

#include <cstddef>
#include <vector>

#include "model/dissimilarity/dissimilarity.h"
#include "model/subset/separation.h"

namespace tact {

// In the dissimilarities' own unit; pairs at a threshold are not below it. `same` is not above
// `confused`.
struct ConfusionThresholds {
    double confused = 0.0;
    double same = 0.0;

    bool operator==(const ConfusionThresholds&) const = default;
};

// [ours] What is half as far apart as people can tell is the same to them.
inline constexpr double kSameShare = 0.5;

enum class ConfusionVerdict { same, hard_to_tell, clear };

inline constexpr const char* kConfusionVerdicts[] = {"same", "hard to tell", "clear"};

ConfusionVerdict verdict_of(double dissimilarity, const ConfusionThresholds& thresholds);

struct NearestNeighbour {
    std::size_t place = 0;
    double dissimilarity = 0.0;  // infinite where no pair is a number; `place` is the pattern's own
    ConfusionVerdict verdict = ConfusionVerdict::clear;

    bool operator==(const NearestNeighbour&) const = default;
};

struct ConfusedGroup {
    std::vector<std::size_t> members;  // ascending
    ConfusablePair closest;
    ConfusablePair farthest;  // of the pairs that are numbers

    bool operator==(const ConfusedGroup&) const = default;
};

struct Confusion {
    ConfusionThresholds thresholds;
    std::vector<NearestNeighbour> nearest;  // of each object; of equals the lowest index
    std::vector<ConfusedGroup> groups;
    std::vector<ConfusablePair>
        links;                       // that hold the groups together, one fewer than members each
    std::size_t confused_pairs = 0;  // all below the threshold

    bool operator==(const Confusion&) const = default;
};

Confusion confusion(const Dissimilarity& dissimilarity, const ConfusionThresholds& thresholds);

// How many objects a person would tell apart if each group were one.
std::size_t distinct_count(const Confusion& confusion);

}  // namespace tact
