// The page about a set that one sends to a client: what feels the same, what to take instead.
//
// Input     what was computed of the set elsewhere; nothing here decides
// Output    one HTML page that stands alone (html.h): map, groups, subset, table of patterns with
//           players, matrix, what was assumed
// Valid     any n: a page of 1,000 patterns stays below 5 MB and opens at once. The matrix is a
// table
//           up to kMostMatrixRows and a picture beyond, lists are cut, players and rows of the
//           table are there as long as they have room, those of the picked ones first; the page
//           says what it leaves out
// Exact     same input, same bytes.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "devices/calibration/rendering.h"
#include "model/dissimilarity/dissimilarity.h"
#include "model/map/mds.h"
#include "model/set/measured_twin.h"
#include "model/set/pattern_set.h"
#include "model/subset/subset.h"
#include "model/subset/subset_stability.h"
#include "model/tasks/set_report.h"

namespace tact {

inline constexpr std::size_t kMostMatrixRows = 160;
inline constexpr std::size_t kMostListedPatterns = 1000;
inline constexpr std::size_t kMostNamed = 60;    // of one group
inline constexpr std::size_t kMostGroups = 40;   // of one table
inline constexpr std::size_t kMostClosest = 20;  // pairs

// What pairs of a set are held against, and where that is from.
struct CloserThan {
    double dissimilarity = 0.0;
    std::string words;   // "your 8", "Click and Tick"
    std::string source;  // "as far apart as the weakest pair of the 8 most distinct, proven"
};

struct Report {
    const PatternSet& set;               // as it is meant
    const PatternSet& felt;              // as a device plays it; the same set where none does
    const Dissimilarity& dissimilarity;  // of what is felt
    std::string quantity = "PM";         // what that is
    SubsetObjective objective = SubsetObjective::max_min;
    SubsetAnswer answer;
    std::optional<double> best_worth{};  // by the objective; where `answer.best` is an alternative
    const PerceptualSpace& space;        // of the whole set ...
    std::string space_of = "PM";         // ... by this
    AlikePatterns alike{};               // those closer than a pair that was chosen are no sign of
                                         // a confusion; no groups: not asked for
    std::vector<std::size_t> unfelt{};   // places that nobody feels: apart
    std::string left_out{};              // "1 not felt pattern left out"; of the picks
    CloserThan closer_than{};            // which
    const Stability* stability = nullptr;  // how sure: if it was asked
    std::optional<RenderedBy> by{};        // the device
    std::string program{};                 // "tactspace 0.1.0"
    std::string date{};                    // of the page
    NumberMark mark{};                     // of every number ...
    std::vector<std::string> labels{};     // ... in sentences, with further ones
};

std::string report_page(const Report& report);

// Default: the weakest pair of the most distinct patterns, and whether these are proven.
CloserThan closer_than_picked(const SubsetAnswer& answer);

// "Proven optimal: ..": what is known of the subset, as a sentence.
std::string proof_sentence(const Report& report);

}  // namespace tact
