#include "model/training/training_grid.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <numeric>

namespace tact {

namespace {

int common_divisor(const ChannelUnits& channel) {
    int divisor = 0;
    for (const int weight : channel) divisor = std::gcd(divisor, weight);
    return divisor;
}

std::uint64_t whole(std::uint64_t units) { return units + 1; }

double steps_between(double a, double b, int units) { return std::abs(a - b) * units; }

double channel_steps(const PerReceptor<double>& a, const PerReceptor<double>& b, int units) {
    double steps = 0.0;
    for (std::size_t c = 0; c < kReceptorCount; ++c) steps += steps_between(a[c], b[c], units);
    return steps;
}

// The one of the first `count` multiples of whole weights that `steps` finds nearest.
template <class Steps>
int nearest_multiple(std::uint32_t count, const Steps& steps) {
    int nearest = 1;
    double least = std::numeric_limits<double>::infinity();
    for (int times = 1; times <= static_cast<int>(count); ++times) {
        const double away = steps(times);
        // Not by rounding alone: the smallest of the equally near.
        if (away >= least - 1e-9) continue;
        least = away;
        nearest = times;
    }
    return nearest;
}

double weight_of(int weight, int times, int units) {
    return static_cast<double>(weight * times) / units;
}

PerReceptor<double> weights_of(const ChannelUnits& channel, int times, int units) {
    PerReceptor<double> weights{};
    for (std::size_t c = 0; c < kReceptorCount; ++c) {
        weights[c] = weight_of(channel[c], times, units);
    }
    return weights;
}

}  // namespace

TrainingGrid training_grid(int units) {
    assert(units >= 1 && "a weight of 1 has at least one step");
    TrainingGrid grid;
    grid.units = units;
    ChannelUnits channel{};
    // An odometer, the last channel's wheel turning fastest.
    for (bool more = true; more;) {
        if (common_divisor(channel) == 1) grid.channels.push_back(channel);
        std::size_t wheel = kReceptorCount;
        while (wheel > 0 && channel[wheel - 1] == units) channel[--wheel] = 0;
        more = wheel > 0;
        if (more) ++channel[wheel - 1];
    }
    for (int nc = 0; nc <= units; ++nc) {
        for (int oc = 0; oc <= units; ++oc) {
            if (std::gcd(nc, oc) == 1) grid.mixes.push_back({nc, oc});
        }
    }
    std::ranges::sort(
        grid.mixes, [](const MixUnits& a, const MixUnits& b) { return a.nc * b.oc < b.nc * a.oc; });
    for (const ChannelUnits& weights : grid.channels) {
        grid.channel_multiples.push_back(
            static_cast<std::uint32_t>(units / std::ranges::max(weights)));
    }
    for (const MixUnits& mix : grid.mixes) {
        grid.mix_multiples.push_back(static_cast<std::uint32_t>(units / std::max(mix.nc, mix.oc)));
    }
    return grid;
}

std::uint64_t combination_count(int units) {
    const std::uint64_t weights = whole(static_cast<std::uint64_t>(units));
    return kTrainedLayers * weights * weights * weights * weights * weights * weights;
}

std::uint64_t combinations_of(const TrainingGrid& grid, const GridPoint& point) {
    const std::uint64_t mixes = grid.mix_multiples[point.mix];
    if (point.channel != kAny) return mixes * grid.channel_multiples[point.channel];
    // NC without a share; or no channel that has one, whatever NC's share.
    const std::uint64_t weights = whole(static_cast<std::uint64_t>(grid.units));
    const std::uint64_t channels = weights * weights * weights * weights;
    return mixes * kTrainedLayers * (channels + static_cast<std::uint64_t>(grid.units));
}

PerceptualModelParams nearest_model(const TrainingGrid& grid, const GridPoint& point,
                                    const PerceptualModelParams& model) {
    PerceptualModelParams result = model;
    const int units = grid.units;
    const MixUnits mix = grid.mixes[point.mix];
    const int mix_times = nearest_multiple(grid.mix_multiples[point.mix], [&](int times) {
        return steps_between(weight_of(mix.nc, times, units), model.nc_weight, units) +
               steps_between(weight_of(mix.oc, times, units), model.oc_weight, units);
    });
    result.nc_weight = weight_of(mix.nc, mix_times, units);
    result.oc_weight = weight_of(mix.oc, mix_times, units);
    if (point.channel == kAny) return result;
    const LayerCounts layers = layers_at(point.layers);
    result.coding.excitatory_layers = layers.excitatory;
    result.coding.inhibitory_layers = layers.inhibitory;
    const ChannelUnits& channel = grid.channels[point.channel];
    const int times = nearest_multiple(grid.channel_multiples[point.channel], [&](int of) {
        return channel_steps(weights_of(channel, of, units), model.channel_weight, units);
    });
    result.channel_weight = weights_of(channel, times, units);
    return result;
}

double parameter_steps(const PerceptualModelParams& a, const PerceptualModelParams& b, int units) {
    return std::abs(a.coding.excitatory_layers - b.coding.excitatory_layers) +
           std::abs(a.coding.inhibitory_layers - b.coding.inhibitory_layers) +
           channel_steps(a.channel_weight, b.channel_weight, units) +
           steps_between(a.nc_weight, b.nc_weight, units) +
           steps_between(a.oc_weight, b.oc_weight, units);
}

}  // namespace tact
