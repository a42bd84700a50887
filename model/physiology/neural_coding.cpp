#include "model/physiology/neural_coding.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdlib>
#include <iterator>

#include "model/physiology/nc_matrix.h"
#include "model/signal/butterworth.h"

namespace tact {

namespace {

double energy(const std::vector<double>& signal) {
    double sum = 0.0;
    for (const double sample : signal) sum += sample * sample;
    return sum;
}

std::vector<double> channel_filter(const std::vector<double>& input_g, Receptor receptor,
                                   const NeuralCodingParams& params) {
    const ReceptorTraits& type = traits(receptor);
    const auto sections =
        type.low_hz > 0.0
            ? band_pass(params.band_pass_order_per_edge, type.low_hz, type.high_hz, kModelRateHz)
            : low_pass(params.low_pass_order, type.high_hz, kModelRateHz);
    return filtered(sections, input_g);
}

// Normalised to its peak; rapidly adapting receptors perceive the change per second.
std::vector<double> perceived_waveform(const std::vector<double>& filtered_g, bool differentiate) {
    double peak_g = 0.0;
    for (const double sample : filtered_g) peak_g = std::max(peak_g, std::abs(sample));
    std::vector<double> perceived(filtered_g.size(), 0.0);
    if (peak_g == 0.0) return perceived;
    double previous = 0.0;
    for (std::size_t n = 0; n < filtered_g.size(); ++n) {
        const double sample = filtered_g[n] / peak_g;
        perceived[n] = differentiate ? (sample - previous) * kModelRateHz : sample;
        previous = sample;
    }
    return perceived;
}

// How much of the way is kept for looking at.
enum class Kept { code, stages, layers };

// What a step brings to the square of `half_width` around the centre.
RelayLayer spikes_of_step(const ChannelStages& channel, int half_width, std::size_t step) {
    RelayLayer layer = empty_layer(half_width);
    for (std::size_t k = 0; k < channel.grid.receptors.size(); ++k) {
        const GridReceptor& receptor = channel.grid.receptors[k];
        if (std::max(std::abs(receptor.column), std::abs(receptor.row)) > half_width) continue;
        layer.cell(receptor.column, receptor.row) = channel.spike_count[k][step];
    }
    return layer;
}

// Whole for the default kernels; a researcher's kernel may leave fractions.
int central_count(double centre) { return static_cast<int>(std::floor(centre + 1e-9)); }

// How far the coding of all channels is, told step by step.
class Watched {
  public:
    Watched(const CodingOptions& options, std::size_t steps)
        : options_(options), steps_(kReceptorCount * steps) {}

    bool is_stopped() const { return options_.stop.stop_requested(); }

    void has_done_step() {
        ++done_;
        if (!options_.progress) return;
        options_.progress(static_cast<double>(done_) / static_cast<double>(steps_));
    }

  private:
    const CodingOptions& options_;
    std::size_t steps_;
    std::size_t done_ = 0;
};

// Counts of the central neuron per step. Unless layers are kept, just the cone that can reach the
// centre is relayed.
std::vector<int> relay_channel(ChannelStages& channel, std::size_t steps,
                               const NeuralCodingParams& params, Kept kept, Watched& watched) {
    const int cone = params.excitatory_layers + params.inhibitory_layers;
    const int half_width = std::min(channel.grid.half_width, cone);
    std::vector<int> central(steps, 0);
    for (std::size_t step = 0; step < steps && !watched.is_stopped(); ++step) {
        if (kept == Kept::layers) {
            channel.layers.push_back(relay_layers(channel, step, params));
            central[step] = central_count(channel.layers.back().back().centre());
        } else {
            const RelayLayer spikes = spikes_of_step(channel, half_width, step);
            // Networks hand on nothing of nothing.
            const bool is_quiet =
                std::ranges::all_of(spikes.cells, [](double count) { return count == 0.0; });
            const std::vector<RelayLayer> layers =
                is_quiet ? std::vector<RelayLayer>() : relay(spikes, params, true);
            central[step] =
                central_count(layers.empty() ? spikes.centre() : layers.back().centre());
        }
        watched.has_done_step();
    }
    return central;
}

struct ChannelInput {
    std::vector<double> input_g;  // mean-removed
    double input_energy = 0.0;
    double duration_s = 0.0;
};

ChannelStages code_channel(const ChannelInput& input, Receptor receptor,
                           const Activation& activated, const NeuralCodingParams& params, Kept kept,
                           const Watched& watched) {
    const int cone = params.excitatory_layers + params.inhibitory_layers;
    const int reach = kept == Kept::code ? cone : kWholeGrid;
    ChannelStages channel;
    channel.grid = receptor_grid(activated, receptor, input.duration_s, params.share, reach);
    channel.filtered_g = channel_filter(input.input_g, receptor, params);
    channel.silent =
        energy(channel.filtered_g) <= params.silent_energy_fraction * input.input_energy;
    if (channel.silent) std::ranges::fill(channel.filtered_g, 0.0);
    channel.perceived = perceived_waveform(channel.filtered_g, traits(receptor).rapidly_adapting);
    const std::vector<double> fractions = energy_fractions(channel.perceived);
    for (const GridReceptor& place : channel.grid.receptors) {
        if (watched.is_stopped()) break;
        channel.spike_count.push_back(spike_counts(fractions, place.fires, params.split));
    }
    return channel;
}

void mark_central_spikes(NeuralCode& code, Receptor receptor) {
    const auto bit = static_cast<std::uint8_t>(1U << index_of(receptor));
    const std::vector<int>& counts = code.central_count[index_of(receptor)];
    for (std::size_t step = 0; step < counts.size(); ++step) {
        for (const std::size_t offset : spread_spikes(counts[step])) {
            code.central_spikes[step * kStepSamples + offset] |= bit;
        }
    }
}

NeuralCodingStages code_waveform(const Waveform& waveform, const NeuralCodingParams& params,
                                 Kept kept, const CodingOptions& options) {
    assert(waveform.rate_hz == kModelRateHz && "the model works at 10 kHz; resample first");
    ChannelInput input;
    input.input_g = params.remove_mean ? without_mean(waveform.samples_g) : waveform.samples_g;
    input.input_energy = energy(input.input_g);
    input.duration_s = duration_s(waveform);

    NeuralCodingStages stages;
    stages.components = components(amplitude_spectrum(input.input_g, kModelRateHz), params);
    const std::size_t steps = step_count(input.input_g.size());
    stages.code.central_spikes.assign(steps * kStepSamples, 0);
    Watched watched(options, steps);
    for (const Receptor receptor : kReceptors) {
        if (watched.is_stopped()) break;
        const std::size_t c = index_of(receptor);
        stages.code.activation[c] = activation(stages.components, receptor, params);
        ChannelStages channel =
            code_channel(input, receptor, stages.code.activation[c], params, kept, watched);
        stages.code.activated[c] = channel.grid.activated;
        stages.code.central_count[c] = relay_channel(channel, steps, params, kept, watched);
        mark_central_spikes(stages.code, receptor);
        if (kept != Kept::code) stages.channel[c] = std::move(channel);
    }
    return stages;
}

// Value of the brain waveform for every pattern of channels that fire.
std::array<double, 16> waveform_levels(const PerReceptor<double>& channel_weight) {
    std::array<double, 16> levels{};
    for (std::size_t mask = 0; mask < levels.size(); ++mask) {
        for (std::size_t c = 0; c < kReceptorCount; ++c) {
            if ((mask >> c & 1U) != 0) levels[mask] += channel_weight[c];
        }
    }
    return levels;
}

}  // namespace

NeuralCode neural_code(const Waveform& waveform, const NeuralCodingParams& params,
                       const CodingOptions& options) {
    return code_waveform(waveform, params, Kept::code, options).code;
}

NeuralCodingStages neural_coding_stages(const Waveform& waveform, const NeuralCodingParams& params,
                                        KeepLayers keep, const CodingOptions& options) {
    return code_waveform(waveform, params, keep == KeepLayers::all ? Kept::layers : Kept::stages,
                         options);
}

std::vector<RelayLayer> relay_layers(const ChannelStages& channel, std::size_t step,
                                     const NeuralCodingParams& params) {
    std::vector<RelayLayer> layers{spikes_of_step(channel, channel.grid.half_width, step)};
    std::vector<RelayLayer> relayed = relay(layers[0], params, false);
    std::ranges::move(relayed, std::back_inserter(layers));
    return layers;
}

std::vector<double> predicted_brain_waveform(const NeuralCode& code,
                                             const PerReceptor<double>& channel_weight) {
    const auto levels = waveform_levels(channel_weight);
    std::vector<double> waveform(code.central_spikes.size());
    std::ranges::transform(code.central_spikes, waveform.begin(),
                           [&levels](std::uint8_t mask) { return levels[mask]; });
    return waveform;
}

double nc_dissimilarity(const NeuralCode& a, const NeuralCode& b,
                        const PerReceptor<double>& channel_weight) {
    return nc_dissimilarity(spike_form(a, b), a.central_spikes.size(), channel_weight);
}

}  // namespace tact
