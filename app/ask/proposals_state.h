// Proposed patterns shown in the map: the track of a number, a suggestion, neighbours.
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

// A question: the places of these patterns in the map, each in the place of the pattern of `row`.
struct ProposalsRequest {
    std::shared_ptr<const LiveMap> map;
    Eigen::MatrixXd points;  // the map as shown
    std::size_t row = 0;
    std::vector<Pattern> patterns{};
    std::optional<VaryQuestion> vary{};  // makes the patterns first
    bool exact = false;                  // false: from coarse envelopes, a quick preview

    bool operator==(const ProposalsRequest& other) const {
        return map == other.map && row == other.row && patterns == other.patterns &&
               vary == other.vary && exact == other.exact && points.rows() == other.points.rows() &&
               points.cols() == other.points.cols() && points == other.points;
    }
};

struct FoundProposals {
    ProposalsRequest request;
    std::vector<Pattern> patterns;
    Eigen::MatrixXd places;  // one row per pattern
};

using ProposalsQuery = Query<ProposalsRequest, FoundProposals>;

// A point was moved: asks for the pattern that belongs to its new place.
struct ReachRequest {
    ProposalsRequest where;  // the map and the row; its patterns are ignored
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

// Patterns around one, kept until that pattern or the numbers that may change are others.
struct KeptSurroundings {
    std::optional<Pattern> of;
    std::vector<PatternParameter> free;
    FeltSteps steps;
    std::vector<Pattern> patterns;
};

struct PutThere {
    std::string name;                          // the moved pattern; empty: no pattern is moved
    std::optional<Eigen::RowVectorXd> wanted;  // a place in the map
    bool is_dragged = false;                   // in this frame
    std::optional<Eigen::RowVectorXd> aim;     // target of the last move, until the next edit ...
    std::uint64_t aim_of = 0;                  // ... after this revision
    KeptSurroundings around;
    ProposalsQuery cloud;                 // the places that can be reached
    Query<ReachRequest, FoundReach> job;  // the search after the mouse button was released
};

struct ProposalsState {
    ProposalsQuery track;        // a preview, soon followed by ...
    ProposalsQuery exact_track;  // ... the exact track
    ProposalsQuery suggestion;
    ProposalsQuery variants;                   // a preview, soon followed by ...
    ProposalsQuery exact_variants;             // ... the exact places
    std::optional<RestedNumber> rested;        // the number whose track is shown
    double rested_until_s = 0.0;               // the track disappears then, unless the mouse is on
                                               // it
    std::optional<SuggestedChange> suggested;  // in the last frame
    std::string varied;                        // name of the varied pattern; empty: no pattern is
                                               // varied
    double how_far = 3.0;                      // felt steps
    std::uint64_t vary_seed = 1;
    std::vector<PatternParameter> held;  // numbers that varying and moving keep
    PutThere put;
    GapQuery gap;
};

}  // namespace tact
