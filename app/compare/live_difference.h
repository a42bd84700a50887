// Why two patterns are as far apart as they are: what each channel has in their NC, when their
// brain waveforms differ, and how their envelopes are warped onto each other.
//
// Exact     the numbers of NC are those of the matrix; the way of the envelopes is that of coarser
//           ones where they are long, and says so (`decimation`).
#pragma once

#include <atomic>
#include <memory>
#include <optional>
#include <stop_token>
#include <vector>

#include "app/map/live_map.h"
#include "model/dtw/dtw_path.h"
#include "model/physiology/nc_shares.h"

namespace tact {

// Two rows of a map that is shown.
struct DifferenceRequest {
    std::shared_ptr<const LiveMap> map;
    std::size_t a = 0;
    std::size_t b = 0;

    bool operator==(const DifferenceRequest&) const = default;
};

struct LiveDifference {
    DifferenceRequest request;
    ChannelShares shares{};
    std::vector<double> apart;  // mean squared difference of the brain waveforms, per 5-ms step
    std::size_t decimation = 1;
    std::vector<double> envelope_a;  // decimated
    std::vector<double> envelope_b;
    DtwPath path;  // between these
};

std::optional<LiveDifference> compute_live_difference(const DifferenceRequest& request,
                                                      std::stop_token stop,
                                                      std::atomic<float>& progress);

}  // namespace tact
