#include "model/physiology/relay_network.h"

#include "tests/support/golden.h"

namespace relay_network_test {

using namespace tact;

namespace {

RelayLayer random_spikes(int half_width, std::uint32_t seed) {
    RelayLayer layer = empty_layer(half_width);
    const auto noise = golden::noise(seed, layer.cells.size(), 2.5);
    for (std::size_t k = 0; k < layer.cells.size(); ++k) {
        layer.cells[k] = std::floor(std::max(0.0, noise.samples_g[k]));
    }
    return layer;
}

}  // namespace

TEST_CASE("relay network: one spike spreads to a cross, then sharpens back") {
    RelayLayer spike = empty_layer(0);
    spike.cell(0, 0) = 1.0;
    NeuralCodingParams params;
    params.excitatory_layers = 1;
    params.inhibitory_layers = 1;
    const auto layers = relay(spike, params, false);
    REQUIRE(layers.size() == 2);
    CHECK(layers[0].cells == std::vector<double>{0, 1, 0, 1, 1, 1, 0, 1, 0});
    // Centre: 5 - 4 = 1; arms: 5 - 1 = 4; corners: 0 - 2 < 0.
    CHECK(layers[1].cells == std::vector<double>{0, 4, 0, 4, 1, 4, 0, 4, 0});
}

TEST_CASE("relay network: no neuron exceeds the cap or falls below silence") {
    const auto layers = relay(random_spikes(6, 5), {}, false);
    REQUIRE(layers.size() == 4);
    for (const RelayLayer& layer : layers) {
        for (const double cell : layer.cells) CHECK((cell >= 0.0 && cell <= 50.0));
    }
}

TEST_CASE("relay network: silence stays silent") {
    for (const RelayLayer& layer : relay(empty_layer(3), {}, false)) {
        CHECK(std::ranges::all_of(layer.cells, [](double cell) { return cell == 0.0; }));
    }
}

TEST_CASE("relay network: the cone alone gives the centre to the bit") {
    for (std::uint32_t seed = 1; seed <= 20; ++seed) {
        NeuralCodingParams params;
        params.excitatory_layers = static_cast<int>(seed % 5);
        params.inhibitory_layers = static_cast<int>(seed % 3);
        params.inhibitory = {2.0, -0.25};
        const RelayLayer spikes = random_spikes(static_cast<int>(seed % 9), seed);
        const auto whole = relay(spikes, params, false);
        const auto cone = relay(spikes, params, true);
        REQUIRE(whole.size() == cone.size());
        if (!whole.empty()) CHECK(cone.back().centre() == whole.back().centre());
    }
}

TEST_CASE("relay network: without layers nothing is relayed") {
    NeuralCodingParams params;
    params.excitatory_layers = 0;
    params.inhibitory_layers = 0;
    CHECK(relay(random_spikes(2, 1), params, false).empty());
}

}  // namespace relay_network_test
