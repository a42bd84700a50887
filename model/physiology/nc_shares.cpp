#include "model/physiology/nc_shares.h"

namespace tact {

ChannelShares nc_shares(const SpikeForm& form, const PerReceptor<double>& channel_weight) {
    ChannelShares shares{};
    // The distance itself tells zero from a rounding error.
    if (nc_dissimilarity(form, 1, channel_weight) == 0.0) return shares;
    double sum = 0.0;
    for (std::size_t c = 0; c < kReceptorCount; ++c) {
        for (std::size_t d = c; d < kReceptorCount; ++d) {
            const double times = c == d ? 1.0 : 2.0;
            shares[c][d] =
                times * channel_weight[c] * channel_weight[d] * static_cast<double>(form[c][d]);
            sum += shares[c][d];
        }
    }
    for (auto& row : shares) {
        for (double& share : row) share /= sum;
    }
    return shares;
}

}  // namespace tact
