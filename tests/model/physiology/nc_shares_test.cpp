#include "model/physiology/nc_matrix.h"

#include <doctest/doctest.h>

#include <cmath>

#include "model/pattern/pattern.h"

namespace nc_shares_test {

using namespace tact;

namespace {

NeuralCode code_of(double frequency_hz, double amplitude_g) {
    Pattern pattern;
    pattern.duration_s = 0.2;
    pattern.amplitude_g = amplitude_g;
    pattern.carriers[0].frequency_hz = frequency_hz;
    return neural_code(render(pattern), {});
}

}  // namespace

TEST_CASE("nc shares: they are all of the squared distance, channel by channel") {
    const NeuralCode a = code_of(60.0, 1.0);
    const NeuralCode b = code_of(250.0, 2.0);
    const SpikeForm form = spike_form(a, b);
    const PerReceptor<double> weight{0.2, 0.7, 0.0, 0.5};
    const ChannelShares shares = nc_shares(form, weight);
    double all = 0.0;
    for (const auto& row : shares) {
        for (const double share : row) all += share;
    }
    CHECK(std::abs(all - 1.0) <= 1e-12);
    // A channel alone: NC with the others' weights at zero.
    const double nc = nc_dissimilarity(a, b, weight);
    for (std::size_t c = 0; c < kReceptorCount; ++c) {
        PerReceptor<double> alone{};
        alone[c] = weight[c];
        const double own = nc_dissimilarity(a, b, alone);
        CHECK(std::abs(shares[c][c] - own * own / (nc * nc)) <= 1e-12);
    }
    // A channel with weight 0 has no share.
    CHECK(shares[2][2] == 0.0);
    CHECK(shares[0][2] == 0.0);
}

TEST_CASE("nc shares: patterns of one brain waveform have none") {
    const NeuralCode a = code_of(60.0, 1.0);
    const SpikeForm same = spike_form(a, a);
    for (const auto& row : nc_shares(same, {0.2, 0.7, 0.0, 0.5})) {
        for (const double share : row) CHECK(share == 0.0);
    }
}

}  // namespace nc_shares_test
