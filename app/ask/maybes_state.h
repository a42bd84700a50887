// Patterns that there are not, shown in the map: the track of a number, a suggestion, neighbours.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/ask/gap_state.h"
#include "app/document/selection.h"
#include "app/jobs/query.h"
#include "app/map/live_map.h"
#include "model/ask/reach.h"
#include "model/ask/vary.h"

namespace tact {

// Where these would be in the map, each in the place of the pattern of a row.
struct MaybesRequest {
    std::shared_ptr<const LiveMap> map;
    Eigen::MatrixXd points;  // of the map, as it is shown
    std::size_t row = 0;
    std::vector<Pattern> patterns{};
    std::optional<VaryQuestion> vary{};  // makes the patterns first
    bool exact = false;                  // else by coarse envelopes: at once, and a preview

    bool operator==(const MaybesRequest& other) const {
        return map == other.map && row == other.row && patterns == other.patterns &&
               vary == other.vary && exact == other.exact && points.rows() == other.points.rows() &&
               points.cols() == other.points.cols() && points == other.points;
    }
};

struct FoundMaybes {
    MaybesRequest request;
    std::vector<Pattern> patterns;
    Eigen::MatrixXd places;  // a row each
};

using MaybesQuery = Query<MaybesRequest, FoundMaybes>;

// A point that is put somewhere else: its pattern is searched.
struct ReachRequest {
    MaybesRequest where;  // the map and the row; its patterns do not count
    ReachQuestion question;

    bool operator==(const ReachRequest& other) const {
        return where == other.where && question.pattern == other.question.pattern &&
               question.target.size() == other.question.target.size() &&
               question.target == other.question.target && question.seed == other.question.seed &&
               question.free == other.question.free && question.steps == other.question.steps;
    }
};

struct FoundReach {
    ReachRequest request;
    Reached reached;
};

// Patterns all around one, kept while they are of the same.
struct KeptSurroundings {
    std::optional<Pattern> of;
    std::vector<PatternParameter> free;
    FeltSteps steps;
    std::vector<Pattern> patterns;
};

struct PutThere {
    std::string name;                          // of the pattern; empty: none is moved
    std::optional<Eigen::RowVectorXd> wanted;  // place of the map
    bool is_dragged = false;                   // in this frame
    std::optional<Eigen::RowVectorXd> aim;     // of the last one, shown until the next edit ...
    std::uint64_t aim_of = 0;                  // ... after this revision
    KeptSurroundings around;
    MaybesQuery cloud;                    // what can be reached
    Query<ReachRequest, FoundReach> job;  // let go there: under way
};

struct MaybesState {
    MaybesQuery track;        // a preview, soon followed by ...
    MaybesQuery exact_track;  // ... where it really leads
    MaybesQuery suggestion;
    MaybesQuery variants;                      // a preview, soon followed by ...
    MaybesQuery exact_variants;                // ... where they really are
    std::optional<RestedNumber> rested;        // whose track is shown
    double rested_until_s = 0.0;               // it goes then, unless the mouse is on it
    std::optional<SuggestedChange> suggested;  // in the last frame
    std::string varied;                        // name of the pattern; empty: nothing is varied
    double how_far = 3.0;                      // felt steps
    std::uint64_t vary_seed = 1;
    std::vector<PatternParameter> held;  // numbers that neither varying nor moving may change
    PutThere put;
    GapQuery gap;
};

}  // namespace tact
