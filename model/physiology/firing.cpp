#include "model/physiology/firing.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace tact {

namespace {

constexpr double kBusiestS = 0.1;
constexpr double kLeastCycles = 4.0;
constexpr double kStrong = 0.5;  // of the strongest component of the band

double peak_of(std::span<const double> samples) {
    double peak = 0.0;
    for (const double sample : samples) peak = std::max(peak, std::abs(sample));
    return peak;
}

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

double fastest_strong_hz(const NeuralCodingStages& stages, Receptor receptor) {
    const double least_g = kStrong * strongest_in_band_g(stages, receptor);
    double fastest_hz = 0.0;
    for (const Component& component : stages.components) {
        if (!is_in_band(component, receptor) || component.amplitude_g <= 0.0) continue;
        if (component.amplitude_g >= least_g) {
            fastest_hz = std::max(fastest_hz, component.frequency_hz);
        }
    }
    return fastest_hz;
}

}  // namespace

bool only_leaks(const Waveform& waveform, const NeuralCodingStages& stages, Receptor receptor) {
    const ChannelStages& channel = stages.channel[index_of(receptor)];
    const double peak_g = peak_of(channel.filtered_g);
    if (channel.silent || peak_g <= 0.0) return false;
    if (peak_g > kLeakShare * peak_of(waveform.samples_g)) return false;
    double strongest_g = 0.0;
    for (const Component& component : stages.components) {
        strongest_g = std::max(strongest_g, component.amplitude_g);
    }
    return strongest_in_band_g(stages, receptor) <= kLeakShare * strongest_g;
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

double impulses_a_cycle(const NeuralCodingStages& stages, Receptor receptor) {
    const std::span<const int> counts = spikes_under_probe(stages.channel[index_of(receptor)]);
    const double fastest_hz = fastest_strong_hz(stages, receptor);
    if (counts.empty() || !(fastest_hz > 0.0)) return 0.0;
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
