// The patterns of a set in groups of alike ones: a tree that is cut where a person likes, and the
// pattern that stands for each group.
//
// Source    average linkage (model/map/group_tree.h)
// Input     a set and the dissimilarities of its patterns, PM or others
// Output    places in the set, everywhere
// Valid     patterns that nobody feels, and dropped ones, are no part of the tree: each is named
//           apart
// Left out  a cut that is right: nobody has measured at which PM people begin to confuse, so that a
//           group orders a library and is no promise. Groups that feel the same are those within a
//           felt step (model/subset/close_groups.h).
// Exact     same input, same groups.
#pragma once

#include <cstddef>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "model/common/expected.h"
#include "model/dissimilarity/dissimilarity.h"
#include "model/map/group_tree.h"
#include "model/set/pattern_set.h"

namespace tact {

struct SetGroups {
    std::vector<std::size_t> grouped;  // places of the tree's objects, ascending
    std::vector<std::size_t> unfelt;   // apart, as nobody could tell them from nothing
    std::vector<std::size_t> dropped;  // apart, but for unfelt ones
    GroupTree tree;
    double agreement = 0.0;  // Spearman's rho of the tree's heights and the dissimilarities

    bool operator==(const SetGroups&) const = default;
};
SetGroups groups_of_set(const PatternSet& set, const Dissimilarity& dissimilarity,
                        std::span<const std::size_t> unfelt);

struct PatternGroup {
    std::vector<std::size_t> members;  // ascending
    std::size_t central = 0;           // closest to all of the group together
    double mean = 0.0;                 // of its pairs; 0 of one pattern
    std::size_t far_a = 0;             // its farthest pair ...
    std::size_t far_b = 0;
    double farthest = 0.0;  // ... and how far apart that is

    bool operator==(const PatternGroup&) const = default;
};

// 8, or half of a small set: for who has not said how many.
std::size_t usual_group_count(std::size_t patterns);

// Into how many groups a tree is cut; neither: the usual number.
struct AskedGroups {
    std::optional<std::size_t> count{};
    std::optional<double> cut{};  // groups stay apart above it; comes before the count
};
// An Error where there are fewer patterns in the tree.
Expected<std::size_t> asked_group_count(const SetGroups& groups, const AskedGroups& asked);

// The tree cut into `count` groups, in the order of the tree's leaves.
std::vector<PatternGroup> groups_at(const SetGroups& groups, const Dissimilarity& dissimilarity,
                                    std::size_t count);

// The patterns that stand for the groups, ascending: the central one of each, or those of its
// patterns that are locked.
std::vector<std::size_t> standing_for(const PatternSet& set, std::span<const PatternGroup> groups);

// {"linkage": "average", "count", "cut": {"from", "below"}, "agreement", "groups": [{"patterns",
// "central", "mean", "farthest": {"a", "b", "dissimilarity"}}], "not_felt", "dropped", "order",
// "joins": [[a, b, height, patterns]]}: joins as SciPy's linkage has them, of the patterns in
// "order".
nlohmann::json json_of(const SetGroups& groups, std::span<const PatternGroup> cut,
                       const std::vector<std::string>& names);

}  // namespace tact
