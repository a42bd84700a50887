#include "app/compare/live_difference.h"

#include "model/perceptual_model/rhythm_envelope.h"
#include "model/physiology/spike_train.h"

namespace tact {

namespace {

// One byte per cell: a few megabytes, and a path fine enough for one line per pixel.
constexpr std::size_t kMostPathSamples = 1500;

std::vector<double> squared_by_step(const PatternCode& a, const PatternCode& b,
                                    const PerReceptor<double>& channel_weight) {
    const std::vector<double> left = predicted_brain_waveform(a.neural, channel_weight);
    const std::vector<double> right = predicted_brain_waveform(b.neural, channel_weight);
    const std::size_t length = std::min(left.size(), right.size());
    std::vector<double> apart((length + kStepSamples - 1) / kStepSamples, 0.0);
    for (std::size_t n = 0; n < length; ++n) {
        const double difference = left[n] - right[n];
        apart[n / kStepSamples] += difference * difference / static_cast<double>(kStepSamples);
    }
    return apart;
}

// With the zeros up to the longest.
std::vector<double> drawn_envelope(const PatternCode& code, std::size_t decimation) {
    std::vector<double> envelope = decimated(code.envelope, decimation, code.samples);
    envelope.resize((code.samples + decimation - 1) / decimation, 0.0);
    return envelope;
}

}  // namespace

std::optional<LiveDifference> compute_live_difference(const DifferenceRequest& request,
                                                      std::stop_token stop,
                                                      std::atomic<float>& progress) {
    const Prediction& prediction = request.map->prediction;
    const PatternCode& a = *prediction.codes[request.a];
    const PatternCode& b = *prediction.codes[request.b];
    const PerReceptor<double>& weight = prediction.params.channel_weight;
    LiveDifference live;
    live.request = request;
    live.shares = nc_shares(spike_form(a.neural, b.neural), weight);
    live.apart = squared_by_step(a, b, weight);
    progress = 0.3F;
    if (stop.stop_requested()) return std::nullopt;
    const std::size_t longest = std::max(a.samples, b.samples);
    live.decimation = std::max<std::size_t>(1, (longest + kMostPathSamples - 1) / kMostPathSamples);
    live.envelope_a = drawn_envelope(a, live.decimation);
    live.envelope_b = drawn_envelope(b, live.decimation);
    live.path = dtw_path(live.envelope_a, live.envelope_b, prediction.params.envelope.waiting_cost);
    progress = 1.0F;
    return live;
}

}  // namespace tact
