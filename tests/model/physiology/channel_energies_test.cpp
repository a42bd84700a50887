#include "model/physiology/channel_energies.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <string>

#include "model/physiology/neural_coding.h"
#include "model/signal/waveform.h"
#include "tests/support/golden.h"
#include "tests/support/mixed_set.h"

namespace channel_energies_test {

using namespace tact;

double energy_of(const std::vector<double>& signal) {
    double sum = 0.0;
    for (const double sample : signal) sum += sample * sample;
    return sum;
}

// The channels one by one, from the kept waveforms.
PerReceptor<std::vector<double>> one_by_one(const Waveform& waveform,
                                            const NeuralCodingParams& params) {
    const auto stages = neural_coding_stages(waveform, params, KeepLayers::none);
    PerReceptor<std::vector<double>> fractions;
    for (std::size_t c = 0; c < kReceptorCount; ++c) {
        fractions[c] = energy_fractions(stages.channel[c].perceived);
    }
    return fractions;
}

TEST_CASE("channel energies: side by side, the channels have the bits of each alone") {
    std::vector<Waveform> waveforms = model_waveforms(mixed_set(12));
    waveforms.push_back(golden::noise(3, 1234, 0.5));  // the last window is short
    waveforms.push_back({kModelRateHz, std::vector<double>(300, 0.0)});
    waveforms.push_back({kModelRateHz, {}});
    NeuralCodingParams other;
    other.band_pass_order_per_edge = 2;  // the low-pass has more sections
    other.low_pass_order = 7;
    NeuralCodingParams deaf;
    deaf.silent_energy_fraction = 0.01;  // some channels are silent
    std::size_t silent = 0;
    for (const NeuralCodingParams& params : {NeuralCodingParams{}, other, deaf}) {
        for (std::size_t k = 0; k < waveforms.size(); ++k) {
            CAPTURE(k);
            const auto expected = one_by_one(waveforms[k], params);
            for (const auto& channel : expected) {
                silent += !channel.empty() && channel.back() == 0.0 ? 1 : 0;
            }
            const auto input_g = without_mean(waveforms[k].samples_g);
            for (const ChannelRunner& runner : channel_runners()) {
                CAPTURE(runner.name);
                CHECK(runner.run(input_g, energy_of(input_g), params) == expected);
            }
        }
    }
    CHECK(silent > 12);
}

TEST_CASE("channel energies: codes of a library have the bits of those with every stage kept") {
    for (const Waveform& waveform : model_waveforms(mixed_set(12))) {
        for (const WindowSplit split : {WindowSplit::halves, WindowSplit::first}) {
            NeuralCodingParams params;
            params.split = split;
            const NeuralCode alone = neural_code(waveform, params);
            const NeuralCode whole = neural_coding_stages(waveform, params, KeepLayers::none).code;
            CHECK(alone.central_count == whole.central_count);
            CHECK(alone.central_spikes == whole.central_spikes);
            CHECK(alone.activation == whole.activation);
            CHECK(alone.activated == whole.activated);
        }
    }
}

}  // namespace channel_energies_test
