#include "model/physiology/firing.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "model/physiology/channel_energies.h"
#include "model/signal/butterworth.h"

namespace tact {

namespace {

constexpr double kBusiestS = 0.1;
constexpr double kLeastCycles = 4.0;
constexpr double kStrong = 0.5;  // relative to the strongest component of the band

bool is_in_band(const Component& component, Receptor receptor) {
    return component.frequency_hz >= traits(receptor).low_hz &&
           component.frequency_hz <= traits(receptor).high_hz;
}

double strongest_in_band_g(const NeuralCodingStages& stages, Receptor receptor) {
    double strongest_g = 0.0;
    for (const Component& component : stages.components) {
        if (is_in_band(component, receptor)) {
            strongest_g = std::max(strongest_g, component.amplitude_g);
        }
    }
    return strongest_g;
}

}  // namespace

bool only_leaks(const NeuralCodingStages& stages, const NeuralCodingParams& params,
                Receptor receptor) {
    double strongest_g = 0.0;
    for (const Component& component : stages.components) {
        strongest_g = std::max(strongest_g, component.amplitude_g);
    }
    if (!(strongest_g > 0.0) || stages.channel[index_of(receptor)].silent) return false;
    const std::vector<Section> sections = channel_sections(receptor, params);
    const double least_g = kLeakShare * strongest_g;
    // A filter never amplifies, so weaker components can be skipped.
    return std::ranges::none_of(stages.components, [&](const Component& component) {
        return component.amplitude_g > least_g &&
               component.amplitude_g * gain(sections, component.frequency_hz, kModelRateHz) >
                   least_g;
    });
}

PerReceptor<Firing> firing_of(const NeuralCodingStages& stages, const NeuralCodingParams& params) {
    const auto has_fired = [](const std::vector<int>& train) {
        return std::ranges::any_of(train, [](int count) { return count > 0; });
    };
    PerReceptor<Firing> firing{};
    for (const Receptor receptor : kReceptors) {
        const std::size_t c = index_of(receptor);
        if (std::ranges::none_of(stages.channel[c].spike_count, has_fired)) continue;
        firing[c] = only_leaks(stages, params, receptor) ? Firing::leaks : Firing::fires;
    }
    return firing;
}

std::vector<char> silent_steps(const Waveform& waveform, const ChannelStages& channel) {
    const std::size_t steps = channel.spike_count.empty() ? 0 : channel.spike_count.front().size();
    const std::size_t samples = waveform.samples_g.size();
    const auto at = [&](std::size_t step) {
        return std::min(sample_count(static_cast<double>(step) * kStepS, waveform.rate_hz),
                        samples);
    };
    std::vector<char> silent(steps, 0);
    for (std::size_t step = 1; step < steps; ++step) {
        const auto since = waveform.samples_g.begin() + static_cast<std::ptrdiff_t>(at(step - 1));
        const auto until = waveform.samples_g.begin() + static_cast<std::ptrdiff_t>(at(step + 1));
        silent[step] = std::all_of(since, until, [](double g) { return g == 0.0; }) ? 1 : 0;
    }
    return silent;
}

SilentFiring silent_firing(const Waveform& waveform, const ChannelStages& channel) {
    const std::vector<char> silent = silent_steps(waveform, channel);
    SilentFiring firing;
    for (const std::vector<int>& counts : channel.spike_count) {
        for (std::size_t step = 0; step < counts.size(); ++step) {
            firing.all += counts[step];
            if (silent[step] != 0) firing.in_silence += counts[step];
        }
    }
    return firing;
}

std::span<const int> spikes_under_probe(const ChannelStages& channel) {
    const auto& all = channel.grid.receptors;
    const auto centre = std::ranges::min_element(all, {}, &GridReceptor::distance_mm);
    const auto k = static_cast<std::size_t>(centre - all.begin());
    if (k >= channel.spike_count.size()) return {};
    return channel.spike_count[k];
}

std::optional<Range> strong_band_hz(const NeuralCodingStages& stages, Receptor receptor) {
    const double least_g = kStrong * strongest_in_band_g(stages, receptor);
    std::optional<Range> band;
    for (const Component& component : stages.components) {
        if (!is_in_band(component, receptor) || component.amplitude_g <= 0.0) continue;
        if (component.amplitude_g < least_g) continue;
        const double hz = component.frequency_hz;
        if (!band) band = Range{hz, hz};
        band = Range{std::min(band->low, hz), std::max(band->high, hz)};
    }
    return band;
}

double impulses_a_cycle(const NeuralCodingStages& stages, Receptor receptor) {
    const std::span<const int> counts = spikes_under_probe(stages.channel[index_of(receptor)]);
    const std::optional<Range> band = strong_band_hz(stages, receptor);
    if (counts.empty() || !band || !(band->high > 0.0)) return 0.0;
    const double fastest_hz = band->high;
    const double wanted = std::ceil(std::max(kBusiestS, kLeastCycles / fastest_hz) / kStepS);
    const std::size_t window = std::min(static_cast<std::size_t>(wanted), counts.size());
    int sum =
        std::accumulate(counts.begin(), counts.begin() + static_cast<std::ptrdiff_t>(window), 0);
    int most = sum;
    for (std::size_t k = window; k < counts.size(); ++k) {
        sum += counts[k] - counts[k - window];
        most = std::max(most, sum);
    }
    return most / (static_cast<double>(window) * kStepS * fastest_hz);
}

}  // namespace tact
