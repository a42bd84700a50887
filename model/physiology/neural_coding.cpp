#include "model/physiology/neural_coding.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdlib>
#include <iterator>
#include <map>

#include "model/physiology/channel_energies.h"
#include "model/physiology/nc_matrix.h"
#include "model/signal/butterworth.h"

namespace tact {

namespace {

double energy(const std::vector<double>& signal) {
    double sum = 0.0;
    for (const double sample : signal) sum += sample * sample;
    return sum;
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

// The spikes of a step in the square of `half_width` around the centre.
RelayLayer spikes_of_step(const ChannelStages& channel, int half_width, std::size_t step) {
    RelayLayer layer = empty_layer(half_width);
    for (std::size_t k = 0; k < channel.grid.receptors.size(); ++k) {
        const GridReceptor& receptor = channel.grid.receptors[k];
        if (std::max(std::abs(receptor.column), std::abs(receptor.row)) > half_width) continue;
        layer.cell(receptor.column, receptor.row) = channel.spike_count[k][step];
    }
    return layer;
}

// The activity that a step's spikes cause at the centre.
double relayed_centre(const RelayLayer& spikes, const NeuralCodingParams& params) {
    // Without spikes, the networks are silent.
    if (std::ranges::all_of(spikes.cells, [](double count) { return count == 0.0; })) return 0.0;
    const std::vector<RelayLayer> layers = relay(spikes, params, true);
    return layers.empty() ? spikes.centre() : layers.back().centre();
}

// Whole for the default kernels; a researcher's kernel may leave fractions.
int central_count(double centre) { return static_cast<int>(std::floor(centre + 1e-9)); }

// Progress of the coding of all channels, step by step.
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

// Counts of the central neuron per step, with all layers kept, or with those of the cone that can
// reach it.
std::vector<int> relay_channel(ChannelStages& channel, std::size_t steps,
                               const NeuralCodingParams& params, KeepLayers keep,
                               Watched& watched) {
    const int cone = params.excitatory_layers + params.inhibitory_layers;
    const int half_width = std::min(channel.grid.half_width, cone);
    std::vector<int> central(steps, 0);
    for (std::size_t step = 0; step < steps && !watched.is_stopped(); ++step) {
        if (keep == KeepLayers::all) {
            channel.layers.push_back(relay_layers(channel, step, params));
            central[step] = central_count(channel.layers.back().back().centre());
        } else {
            const RelayLayer spikes = spikes_of_step(channel, half_width, step);
            central[step] = central_count(relayed_centre(spikes, params));
        }
        watched.has_done_step();
    }
    return central;
}

// The same from a grid of the cone alone. Receptors with equal impulses spike alike, and steps with
// the same spikes are relayed once: most patterns have few different ones of either.
std::vector<int> relay_cone(const ReceptorGrid& grid, std::span<const double> fractions,
                            std::size_t steps, const NeuralCodingParams& params, Watched& watched) {
    std::vector<double> kinds;  // by their number of impulses
    std::vector<std::size_t> kind_of;
    std::vector<std::vector<int>> spikes_of;
    for (const GridReceptor& receptor : grid.receptors) {
        const auto known = std::ranges::find(kinds, receptor.fires);
        kind_of.push_back(static_cast<std::size_t>(known - kinds.begin()));
        if (known != kinds.end()) continue;
        kinds.push_back(receptor.fires);
        spikes_of.push_back(spike_counts(fractions, receptor.fires, params.split));
    }
    const int cone = params.excitatory_layers + params.inhibitory_layers;
    RelayLayer spikes = empty_layer(std::min(grid.half_width, cone));
    std::map<std::vector<int>, int> relayed;
    std::vector<int> now(kinds.size());
    std::vector<int> central(steps, 0);
    for (std::size_t step = 0; step < steps && !watched.is_stopped(); ++step) {
        for (std::size_t kind = 0; kind < kinds.size(); ++kind) now[kind] = spikes_of[kind][step];
        const auto [place, is_new] = relayed.try_emplace(now, 0);
        if (is_new) {
            for (std::size_t k = 0; k < kind_of.size(); ++k) {
                const GridReceptor& receptor = grid.receptors[k];
                spikes.cell(receptor.column, receptor.row) = now[kind_of[k]];
            }
            place->second = central_count(relayed_centre(spikes, params));
        }
        central[step] = place->second;
        watched.has_done_step();
    }
    return central;
}

struct ChannelInput {
    std::vector<double> input_g;  // mean-removed
    double input_energy = 0.0;
    double duration_s = 0.0;
    std::vector<Component> components;
};

ChannelInput channel_input(const Waveform& waveform, const NeuralCodingParams& params) {
    assert(waveform.rate_hz == kModelRateHz && "the model works at 10 kHz; resample first");
    ChannelInput input;
    input.input_g = params.remove_mean ? without_mean(waveform.samples_g) : waveform.samples_g;
    input.input_energy = energy(input.input_g);
    input.duration_s = duration_s(waveform);
    input.components = components(amplitude_spectrum(input.input_g, kModelRateHz), params);
    return input;
}

ChannelStages code_channel(const ChannelInput& input, Receptor receptor,
                           const Activation& activated, const NeuralCodingParams& params,
                           const Watched& watched) {
    ChannelStages channel;
    channel.grid = receptor_grid(activated, receptor, input.duration_s, params.share);
    channel.filtered_g = filtered(channel_sections(receptor, params), input.input_g);
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

// The value of the brain waveform for every combination of firing channels.
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
    const ChannelInput input = channel_input(waveform, params);
    const std::size_t steps = step_count(input.input_g.size());
    const int cone = params.excitatory_layers + params.inhibitory_layers;
    NeuralCode code;
    code.central_spikes.assign(steps * kStepSamples, 0);
    code.activation = activations(input.components, params);
    if (options.stop.stop_requested()) return code;
    const auto fractions = channel_energy_fractions(input.input_g, input.input_energy, params);
    Watched watched(options, steps);
    for (const Receptor receptor : kReceptors) {
        if (watched.is_stopped()) break;
        const std::size_t c = index_of(receptor);
        const ReceptorGrid grid =
            receptor_grid(code.activation[c], receptor, input.duration_s, params.share, cone);
        code.activated[c] = grid.activated;
        code.central_count[c] = relay_cone(grid, fractions[c], steps, params, watched);
        mark_central_spikes(code, receptor);
    }
    return code;
}

NeuralCodingStages neural_coding_stages(const Waveform& waveform, const NeuralCodingParams& params,
                                        KeepLayers keep, const CodingOptions& options) {
    const ChannelInput input = channel_input(waveform, params);
    NeuralCodingStages stages;
    stages.components = input.components;
    const std::size_t steps = step_count(input.input_g.size());
    stages.code.central_spikes.assign(steps * kStepSamples, 0);
    stages.code.activation = activations(input.components, params);
    Watched watched(options, steps);
    for (const Receptor receptor : kReceptors) {
        if (watched.is_stopped()) break;
        const std::size_t c = index_of(receptor);
        ChannelStages& channel = stages.channel[c];
        channel = code_channel(input, receptor, stages.code.activation[c], params, watched);
        stages.code.activated[c] = channel.grid.activated;
        stages.code.central_count[c] = relay_channel(channel, steps, params, keep, watched);
        mark_central_spikes(stages.code, receptor);
    }
    return stages;
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
