// What is told of a set as a whole: what feels the same, what to pick instead, what is close, what
// nobody feels, the map, and how sure all that is. The page, the terminal and Python tell it.
//
// Input     the set that is meant, whose locks and felt steps count; and the one that is felt,
//           which is compared
// Output    PM of pairs; places in the set
// Exact     same request, same answer, on any number of threads, unless time runs out.
#pragma once

#include <cstddef>
#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <span>
#include <stop_token>
#include <string>
#include <utility>
#include <vector>

#include "model/grouping/set_groups.h"
#include "model/map/mds.h"
#include "model/subset/close_groups.h"
#include "model/subset/subset.h"
#include "model/subset/subset_stability.h"
#include "model/tasks/set_pairs.h"

namespace tact {

// The same pairs, but that what nobody feels is close to nothing: its pairs are infinitely far.
Dissimilarity felt_pairs(Dissimilarity apart, std::span<const std::size_t> unfelt);

// Which patterns of a set are alike.
struct AlikePatterns {
    CloseGroups confused;              // within a felt step: they feel the same
    CloseGroups closer;                // below a threshold that somebody chose
    std::vector<PatternGroup> groups;  // the tree of groups, cut
};

// `threshold`: in the unit of the pairs, of any metric or ratings. `groups`: as many as that, or as
// there are patterns in the tree.
AlikePatterns alike_patterns(const PatternSet& meant, const SetPairs& pairs, double threshold,
                             std::size_t groups);

struct SetReportRequest {
    std::optional<std::size_t> count{};   // to pick; default: 8, or half of a small set
    bool picks_unfelt = false;            // those that nobody feels may be picked, too
    std::optional<double> closer_than{};  // PM; default: of the pair that follows ...
    std::optional<std::pair<std::size_t, std::size_t>> closer_than_pair{};  // ... or of the weakest
    std::size_t draws = 0;  // of what is uncertain in the model
    int threads = 0;        // 0: all cores
    std::stop_token stop{};
    SubsetOptions picking{};                  // its limit, and who is told
    std::function<void(double)> comparing{};  // how far it is, 0..1, from any thread
    std::function<void(double)> drawing{};    // likewise
};

struct SetReport {
    SetPairs pairs;
    std::string fault;  // why no subset can be picked: what follows is empty then
    SubsetAnswer subset;
    std::vector<std::size_t> left_out;  // of the picks, because nobody feels them
    double closer_than = 0.0;           // PM
    AlikePatterns alike;                // as many groups as patterns are picked
    PerceptualSpace space;
    std::optional<Stability> stability;
};

// Nothing when stopped. There are at least two patterns, the same in both sets.
std::optional<SetReport> set_report(const PatternSet& meant, const PatternSet& felt,
                                    const SetReportRequest& request = {});

// {"picked", "optimal", "bound", "groups", "confused_pairs", "distinct", "closer_below",
// "closer_pairs", "closer_groups", "alike": [{"central", "patterns"}], "nearest": {name:
// {"pattern", "dissimilarity", "verdict"}}, "not_felt", "left_out_unfelt"}: "groups", "distinct"
// and verdicts are of felt steps, and what begins with "closer" is of a pair. The last two are
// there if there are any.
nlohmann::json json_of(const SetReport& report, const PatternSet& meant);

}  // namespace tact
