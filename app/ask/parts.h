// Jobs that compute the places of proposed patterns in a map. Private to the room.
#pragma once

#include <atomic>
#include <memory>
#include <optional>
#include <stop_token>

#include "app/ask/ask.h"
#include "app/document/workspace.h"
#include "app/map/map.h"
#include "model/ask/moved_point.h"

namespace tact {

// Keeps whatever does not depend on the proposed pattern between calls.
class ProposalsWork {
  public:
    std::optional<FoundProposals> operator()(const ProposalsRequest& request, std::stop_token stop,
                                             std::atomic<float>& progress);
    std::optional<FoundReach> operator()(const ReachRequest& request, std::stop_token stop,
                                         std::atomic<float>& progress);

  private:
    bool prepare(const ProposalsRequest& request, const std::stop_token& stop);

    std::optional<MovedPoint> point_;
    std::shared_ptr<const LiveMap> of_;
    std::size_t row_ = 0;
    Eigen::MatrixXd points_;
    bool exact_ = false;
};

// The same request with exact envelopes if the map is exact and the estimated time for this many
// patterns is at most `kLongestExactS`; otherwise the request unchanged.
inline constexpr double kLongestExactS = 8.0;
ProposalsRequest exactly(ProposalsRequest request, std::size_t patterns);

// A request for the map on screen; nullopt if that map belongs to an earlier revision or lacks the
// pattern. Patterns longer than the longest of the set are left out.
std::optional<ProposalsRequest> request_for(const Workspace& work, const ShownMap& shown_map,
                                            const std::string& name, std::vector<Pattern> patterns);

// The numbers that may change; empty: all.
std::vector<PatternParameter> free_of(const ProposalsState& state);

}  // namespace tact
