#include "model/physiology/neural_coding.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>
#include <cstdlib>
#include <iterator>
#include <map>
#include <numeric>

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
    double stands_for = 1.0;  // components, each of these
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

// Samples whose spectrum is fine enough to see each bend of that of `own` ones, and which leave the
// filters a second to fall silent: 8, 10, 12 or 16 times a power of two, which FFTW likes.
std::size_t quick_samples(std::size_t own) {
    constexpr std::size_t kFiner = 4;
    const std::size_t least = std::max(kFiner * own, own + static_cast<std::size_t>(kModelRateHz));
    const std::size_t eighth = std::bit_floor(least) / 8;
    const std::size_t eighths = (least + eighth - 1) / eighth;
    const std::size_t even = (eighths + 1) / 2 * 2;
    return (even == 14 ? 16 : even) * eighth;
}

ChannelInput quick_input(const Waveform& own, std::size_t samples,
                         const NeuralCodingParams& params) {
    const std::size_t count = quick_samples(own.samples_g.size());
    const double share = static_cast<double>(count) / static_cast<double>(samples);
    ChannelInput input;
    input.input_g = padded(own, count).samples_g;
    const double mean_g = std::accumulate(own.samples_g.begin(), own.samples_g.end(), 0.0) /
                          static_cast<double>(samples);
    if (params.remove_mean) {
        for (double& sample_g : input.input_g) sample_g -= mean_g;
    }
    input.input_energy = energy(input.input_g);
    input.duration_s = static_cast<double>(samples) / kModelRateHz;
    Spectrum spectrum = amplitude_spectrum(input.input_g, kModelRateHz);
    for (double& amplitude_g : spectrum.amplitude_g) amplitude_g *= share;
    input.components = components(spectrum, params);
    // A finer spectrum has more components, but not more peaks.
    if (params.components == Components::all) input.stands_for = 1.0 / share;
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

namespace {

NeuralCode code_of(const ChannelInput& input, const NeuralCodingParams& params,
                   const CodingOptions& options) {
    const std::size_t steps = step_count(input.input_g.size());
    const int cone = params.excitatory_layers + params.inhibitory_layers;
    NeuralCode code;
    code.samples = steps * kStepSamples;
    code.central_spikes.assign(code.samples, 0);
    code.activation = activations(input.components, params);
    for (Activation& one : code.activation) {
        one.rate_hz *= input.stands_for;
        one.slope_sum *= input.stands_for;
    }
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

}  // namespace

NeuralCode neural_code(const Waveform& waveform, const NeuralCodingParams& params,
                       const CodingOptions& options) {
    return code_of(channel_input(waveform, params), params, options);
}

bool can_be_quick(const Waveform& own, std::size_t samples) {
    return 2 * quick_samples(own.samples_g.size()) <= samples;
}

NeuralCode quick_neural_code(const Waveform& own, std::size_t samples,
                             const NeuralCodingParams& params) {
    assert(own.rate_hz == kModelRateHz && "the model works at 10 kHz; resample first");
    if (!can_be_quick(own, samples)) return neural_code(padded(own, samples), params);
    NeuralCode code = code_of(quick_input(own, samples, params), params, {});
    code.samples = step_count(samples) * kStepSamples;
    return code;
}

NeuralCodingStages neural_coding_stages(const Waveform& waveform, const NeuralCodingParams& params,
                                        KeepLayers keep, const CodingOptions& options) {
    const ChannelInput input = channel_input(waveform, params);
    NeuralCodingStages stages;
    stages.components = input.components;
    const std::size_t steps = step_count(input.input_g.size());
    stages.code.samples = steps * kStepSamples;
    stages.code.central_spikes.assign(stages.code.samples, 0);
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

void drop_silent_end(NeuralCode& code) {
    const auto drop = [](auto& values) {
        while (!values.empty() && values.back() == 0) values.pop_back();
        values.shrink_to_fit();
    };
    for (std::vector<int>& counts : code.central_count) drop(counts);
    drop(code.central_spikes);
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
    std::vector<double> waveform(code.samples);
    std::ranges::transform(code.central_spikes, waveform.begin(),
                           [&levels](std::uint8_t mask) { return levels[mask]; });
    return waveform;
}

double nc_dissimilarity(const NeuralCode& a, const NeuralCode& b,
                        const PerReceptor<double>& channel_weight) {
    return nc_dissimilarity(spike_form(a, b), a.samples, channel_weight);
}

}  // namespace tact
