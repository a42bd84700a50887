#include "model/physiology/spike_train.h"

#include <algorithm>
#include <cmath>

namespace tact {

namespace {

// Limit of one receptor's spikes, far above real numbers and the relays' resolution; it keeps their
// sums whole.
constexpr double kMostInWindow = 1e6;

}  // namespace

std::vector<double> energy_fractions(std::span<const double> perceived) {
    std::vector<double> fractions(window_count(perceived.size()), 0.0);
    double energy = 0.0;
    for (std::size_t window = 0; window < fractions.size(); ++window) {
        const std::size_t begin = window * kWindowSamples;
        const std::size_t end = std::min(begin + kWindowSamples, perceived.size());
        for (std::size_t n = begin; n < end; ++n) energy += perceived[n] * perceived[n];
        fractions[window] = energy;
    }
    for (double& fraction : fractions) fraction = energy > 0.0 ? fraction / energy : 0.0;
    return fractions;
}

std::vector<int> spike_counts(std::span<const double> energy_fractions, double fires,
                              WindowSplit split) {
    std::vector<int> counts;
    counts.reserve(2 * energy_fractions.size());
    double before = 0.0;
    for (const double fraction : energy_fractions) {
        const double so_far = std::floor(fires * fraction + 1e-9);
        const double more = so_far - before;
        const int in_window = static_cast<int>(more < kMostInWindow ? more : kMostInWindow);
        before = so_far;
        const int first = split == WindowSplit::halves ? (in_window + 1) / 2 : in_window;
        counts.push_back(first);
        counts.push_back(in_window - first);
    }
    return counts;
}

std::vector<std::size_t> spread_spikes(int count) {
    const std::size_t spikes = std::min(static_cast<std::size_t>(std::max(count, 0)), kStepSamples);
    std::vector<std::size_t> offsets;
    for (std::size_t k = 0; k < spikes; ++k) offsets.push_back(k * kStepSamples / spikes);
    return offsets;
}

}  // namespace tact
