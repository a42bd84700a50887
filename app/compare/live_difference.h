// Why two patterns differ: the share of each channel in their NC, the times at which their brain
// waveforms differ, and the warping of their envelopes onto each other.
//
// Exact     the numbers of NC are those of the matrix; the path of long envelopes is computed on
//           decimated ones (`decimation`).
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

// Two rows of a shown map.
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
    DtwPath path;  // between the decimated envelopes
};

std::optional<LiveDifference> compute_live_difference(const DifferenceRequest& request,
                                                      std::stop_token stop,
                                                      std::atomic<float>& progress);

}  // namespace tact
