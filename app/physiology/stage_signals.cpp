#include "app/physiology/physiology.h"

#include <algorithm>

#include "model/signal/waveform.h"

namespace tact {

namespace {

using Channels = PerReceptor<std::vector<double>>;

// Channels silent in `live` are listed too: their place on the screen stays theirs.
std::vector<StageSignal> channel_signals(const Channels& channels, StageSignal sample) {
    std::vector<StageSignal> signals;
    const std::string stage = sample.id;
    for (const Receptor receptor : kReceptors) {
        sample.id = stage + " " + traits(receptor).afferent;
        sample.receptor = receptor;
        sample.samples = channels[index_of(receptor)];
        signals.push_back(sample);
    }
    return signals;
}

std::vector<StageSignal> filtered_signals(const LiveStages& live) {
    std::vector<StageSignal> signals;
    for (const Receptor receptor : kReceptors) {
        signals.push_back({.id = std::string("filtered ") + traits(receptor).afferent,
                           .receptor = receptor,
                           .samples = live.neural.channel[index_of(receptor)].filtered_g,
                           .is_signed = true,
                           .unit = "g"});
    }
    return signals;
}

double sum(const PerReceptor<double>& values) {
    double total = 0.0;
    for (const double value : values) total += value;
    return total;
}

// Amplitudes on the common raster of bins: equal lengths make equal bins.
std::vector<double> amplitudes_um(const LiveStages& live) {
    std::vector<double> values;
    const double duration = duration_s(live.waveform);
    for (const Component& component : live.neural.components) {
        const auto bin = static_cast<std::size_t>(component.frequency_hz * duration + 0.5);
        if (values.size() <= bin) values.resize(bin + 1, 0.0);
        values[bin] = component.skin_um;
    }
    return values;
}

// Impulses/s of each population.
std::vector<double> population_rates_hz(const LiveStages& live) {
    std::vector<double> rates;
    for (std::size_t c = 0; c < kReceptorCount; ++c) {
        rates.push_back(static_cast<double>(live.neural.code.activated[c]) *
                        live.neural.code.activation[c].rate_hz);
    }
    return rates;
}

// All channels one after the other, so that one number speaks for them.
std::vector<double> joined(const std::vector<StageSignal>& signals) {
    std::vector<double> all;
    for (const StageSignal& signal : signals) {
        all.insert(all.end(), signal.samples.begin(), signal.samples.end());
    }
    return all;
}

std::optional<double> stage_difference(const LiveStages& a, const LiveStages& b, Stage stage) {
    switch (stage) {
        case Stage::spectrum:
            return relative_difference(amplitudes_um(a), amplitudes_um(b));
        case Stage::receptors:
            return relative_difference(population_rates_hz(a), population_rates_hz(b));
        case Stage::networks:
            return std::nullopt;
        default:
            return relative_difference(joined(signals_of(a, stage)), joined(signals_of(b, stage)));
    }
}

}  // namespace

std::vector<StageSignal> signals_of(const LiveStages& live, Stage stage) {
    switch (stage) {
        case Stage::vibration:
            return {{.id = "vibration",
                     .samples = live.waveform.samples_g,
                     .is_signed = true,
                     .unit = "g"}};
        case Stage::filtered:
            return filtered_signals(live);
        case Stage::spikes:
            return channel_signals(live.population_hz,
                                   {.id = "spikes", .rate_hz = kStepRateHz, .unit = "imp/s"});
        case Stage::central:
            return channel_signals(
                live.central_count,
                {.id = "central",
                 .rate_hz = kStepRateHz,
                 .largest = static_cast<double>(live.request.model.coding.spike_cap)});
        case Stage::brain:
            return {{.id = "brain",
                     .samples = live.brain_waveform,
                     .largest = sum(live.request.model.channel_weight)}};
        case Stage::envelope:
            return {{.id = "envelope", .samples = live.envelope}};
        case Stage::spectrum:
        case Stage::receptors:
        case Stage::networks:
            break;
    }
    return {};
}

StageDifferences stage_differences(const LiveStages& a, const LiveStages& b) {
    StageDifferences differences;
    for (const Stage stage : kStages) {
        differences[index_of(stage)] = stage_difference(a, b, stage);
    }
    return differences;
}

std::vector<std::vector<double>> signal_differences(const LiveStages& a, const LiveStages& b,
                                                    Stage stage) {
    std::vector<std::vector<double>> differences;
    const std::vector<StageSignal> left = signals_of(a, stage);
    const std::vector<StageSignal> right = signals_of(b, stage);
    for (std::size_t k = 0; k < left.size(); ++k) {
        const std::size_t length = std::min(left[k].samples.size(), right[k].samples.size());
        std::vector<double> apart(length);
        for (std::size_t n = 0; n < length; ++n) {
            apart[n] = left[k].samples[n] - right[k].samples[n];
        }
        differences.push_back(std::move(apart));
    }
    return differences;
}

}  // namespace tact
