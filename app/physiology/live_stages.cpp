#include "app/physiology/live_stages.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "model/perceptual_model/rhythm_envelope.h"

namespace tact {

namespace {

std::vector<double> population_hz(const ChannelStages& channel, std::size_t steps) {
    std::vector<double> rate_hz(steps, 0.0);
    for (const std::vector<int>& train : channel.spike_count) {
        for (std::size_t step = 0; step < steps; ++step) rate_hz[step] += train[step];
    }
    for (double& rate : rate_hz) rate *= kStepRateHz;
    return rate_hz;
}

std::vector<std::size_t> by_distance(const ReceptorGrid& grid) {
    std::vector<std::size_t> order(grid.receptors.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::stable_sort(order, {},
                             [&grid](std::size_t k) { return grid.receptors[k].distance_mm; });
    return order;
}

void add_firing(LiveStages& live) {
    const NeuralCodingParams& params = live.request.model.coding;
    live.firing = firing_of(live.neural, params);
    for (const Receptor receptor : kReceptors) {
        const std::size_t c = index_of(receptor);
        const ChannelStages& channel = live.neural.channel[c];
        live.only_leaks[c] = only_leaks(live.neural, params, receptor);
        live.impulses_a_cycle[c] = impulses_a_cycle(live.neural, receptor);
        live.silent_steps[c] = silent_steps(live.waveform, channel);
        live.silent_firing[c] = silent_firing(live.waveform, channel);
    }
    const BesideInput input{live.waveform, live.neural, params.tables, live.firing};
    for (const Stage stage : kStages) {
        live.beside[index_of(stage)] = beside_the_model(text_of(stage).key, input);
    }
}

}  // namespace

LiveStagesRequest stages_request(const PatternSet& set, std::size_t index,
                                 const std::optional<RenderedBy>& rendered_by) {
    return {set.vibrations[index], longest_samples(set), set.model, rendered_by};
}

std::optional<LiveStages> compute_live_stages(const LiveStagesRequest& request,
                                              std::stop_token stop, std::atomic<float>& progress) {
    LiveStages live;
    live.request = request;
    Waveform waveform = waveform_of(request.vibration);
    if (request.rendered_by) waveform = rendering(*request.rendered_by, waveform).waveform;
    live.waveform = padded(std::move(waveform), request.samples);
    live.neural =
        neural_coding_stages(live.waveform, request.model.coding, KeepLayers::none, {stop});
    progress = 0.8F;
    if (stop.stop_requested()) return std::nullopt;
    add_firing(live);
    const NeuralCode& code = live.neural.code;
    for (std::size_t c = 0; c < kReceptorCount; ++c) {
        const std::vector<int>& counts = code.central_count[c];
        live.population_hz[c] = population_hz(live.neural.channel[c], counts.size());
        live.central_count[c].assign(counts.begin(), counts.end());
        for (const std::uint8_t mask : code.central_spikes) {
            live.central_spikes[c].push_back(mask >> c & 1U);
        }
        live.by_distance[c] = by_distance(live.neural.channel[c].grid);
    }
    live.brain_waveform = predicted_brain_waveform(code, request.model.channel_weight);
    live.envelope = rhythm_envelope(live.waveform.samples_g, request.model.envelope);
    progress = 1.0F;
    return live;
}

}  // namespace tact
