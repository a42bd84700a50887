// The work of the jobs that ask where patterns would be in a map. Private to the room.
#pragma once

#include <atomic>
#include <memory>
#include <optional>
#include <stop_token>

#include "app/ask/maybes_state.h"
#include "app/document/workspace.h"
#include "app/map/map_state.h"
#include "model/ask/moved_point.h"

namespace tact {

// Keeps what is the same for every pattern in the place of one.
class MaybesWork {
  public:
    std::optional<FoundMaybes> operator()(const MaybesRequest& request, std::stop_token stop,
                                          std::atomic<float>& progress);
    std::optional<FoundReach> operator()(const ReachRequest& request, std::stop_token stop,
                                         std::atomic<float>& progress);

  private:
    bool prepare(const MaybesRequest& request, const std::stop_token& stop);

    std::optional<MovedPoint> point_;
    std::shared_ptr<const LiveMap> of_;
    std::size_t row_ = 0;
    Eigen::MatrixXd points_;
    bool exact_ = false;
};

// The same by exact envelopes, where the map is exact and that many patterns take no more than this
// by estimate; else as it is.
inline constexpr double kLongestExactS = 8.0;
MaybesRequest exactly(MaybesRequest request, std::size_t patterns);

// Of the map on screen; none where there is no map of the document as it is, or the pattern is not
// in it. Patterns that are longer than all others are left out.
std::optional<MaybesRequest> request_for(const Workspace& work, const ShownMap& shown_map,
                                         const std::string& name, std::vector<Pattern> patterns);

// Those that may change, of all there are; empty: all.
std::vector<PatternParameter> free_of(const MaybesState& state);

}  // namespace tact
