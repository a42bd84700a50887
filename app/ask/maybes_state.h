// Patterns that there are not, shown in the map: the track of a number, a suggestion, neighbours.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/document/selection.h"
#include "app/jobs/latest_job.h"
#include "app/map/live_map.h"
#include "model/ask/vary.h"

namespace tact {

// Where these would be in the map, each in the place of the pattern of a row.
struct MaybesRequest {
    std::shared_ptr<const LiveMap> map;
    Eigen::MatrixXd points;  // of the map, as it is shown
    std::size_t row = 0;
    std::vector<Pattern> patterns{};
    std::optional<VaryQuestion> vary{};  // makes the patterns first

    bool operator==(const MaybesRequest& other) const {
        return map == other.map && row == other.row && patterns == other.patterns &&
               vary == other.vary && points.rows() == other.points.rows() &&
               points.cols() == other.points.cols() && points == other.points;
    }
};

struct FoundMaybes {
    MaybesRequest request;
    std::vector<Pattern> patterns;
    Eigen::MatrixXd places;  // a row each
};

struct AskedMaybes {
    std::unique_ptr<LatestJob<MaybesRequest, FoundMaybes>> job;  // null until the program has begun
    std::optional<MaybesRequest> asked;
};

struct MaybesState {
    AskedMaybes track;
    AskedMaybes suggestion;
    AskedMaybes variants;
    std::optional<RestedNumber> rested;  // whose track is shown
    double rested_until_s = 0.0;         // it goes then, unless the mouse is on it
    std::optional<SuggestedChange> suggested;  // in the last frame
    std::string varied;                  // name of the pattern; empty: nothing is varied
    double how_far = 3.0;                // felt steps
    std::uint64_t vary_seed = 1;
};

}  // namespace tact
