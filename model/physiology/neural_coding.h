// Neural coding: from the vibration at the skin to the predicted brain waveform.
//
//     spectrum -> rates and radius -> receptor grid -> filtered, perceived waveform
//     -> spikes -> relay networks -> four central signals -> predicted brain waveform
//
// Source    Lim & Park 2023, section 4.
// Input     one waveform at 10 kHz; all of a set have the same length
// Output    when each channel's central neuron fires, to the sample; on request every stage
// Valid     validated by the paper at 1 s; other lengths keep their rates (section 7.2)
// Left out  noise, adaptation, conduction delays, other skin sites and probes.
// Exact     same input, same bits, on any number of threads and any instruction set.
#pragma once

#include <cstdint>
#include <functional>
#include <stop_token>
#include <vector>

#include "model/physiology/activation.h"
#include "model/physiology/receptor_grid.h"
#include "model/physiology/relay_network.h"
#include "model/physiology/spike_train.h"
#include "model/signal/waveform.h"

namespace tact {

// The data needed to compare patterns, and no more.
struct NeuralCode {
    PerReceptor<Activation> activation;
    PerReceptor<std::size_t> activated{};         // receptors, N
    PerReceptor<std::vector<int>> central_count;  // spikes of the central neuron per 5 ms step
    // Bit c of sample n: channel c's central neuron fires. None fires at samples behind the last.
    std::vector<std::uint8_t> central_spikes;
    std::size_t samples = 0;  // that were coded: 100 ceil(N / 100)
};

// Drops the steps and samples behind the last spike: codes of short patterns in a set with a long
// one are as short as they are.
void drop_silent_end(NeuralCode& code);

// All stages of one channel, for inspection.
struct ChannelStages {
    ReceptorGrid grid;
    std::vector<double> perceived;                // normalised; differentiated for FA1, FA2
    std::vector<double> filtered_g;               // before normalisation
    bool silent = false;                          // nearly no energy in the channel's band
    std::vector<std::vector<int>> spike_count;    // receptor (as in grid), 5 ms step
    std::vector<std::vector<RelayLayer>> layers;  // step, layer; layer 0 are the spikes; may be
                                                  // empty
};

struct NeuralCodingStages {
    std::vector<Component> components;
    PerReceptor<ChannelStages> channel;
    NeuralCode code;
};

struct CodingOptions {
    // After a request to stop, coding ends within a step, and its result must not be used.
    std::stop_token stop = {};
    // Share of the finished steps, 0..1: called after each step of a channel.
    std::function<void(double)> progress = {};
};

// The code alone; about a millisecond for 1 s.
NeuralCode neural_code(const Waveform& waveform, const NeuralCodingParams& params,
                       const CodingOptions& options = {});

// An approximation for a waveform that is followed by many zeros, up to `samples` in all, at the
// cost of its own length. The spectrum of all samples is a smooth curve through that of a few times
// its own: each component of these stands for all of the others around it. Spikes end with a
// second of silence.
//
// Left out  the energy that a low-pass channel still has from the removed mean
// Valid     can_be_quick(); other waveforms cost as much as neural_code()
bool can_be_quick(const Waveform& own, std::size_t samples);
NeuralCode quick_neural_code(const Waveform& own, std::size_t samples,
                             const NeuralCodingParams& params);

// The layers of the relay networks to keep.
enum class KeepLayers {
    all,  // of every step; memory grows with the grids: tens of MB for strong tones
    none  // relay_layers() computes those of a step
};

// The same numbers with every stage kept.
NeuralCodingStages neural_coding_stages(const Waveform& waveform, const NeuralCodingParams& params,
                                        KeepLayers keep = KeepLayers::all,
                                        const CodingOptions& options = {});

// The layers of one step, the spikes first: 1 + L_E + L_I of them, equal to the kept ones. `step`
// is below the count of steps.
std::vector<RelayLayer> relay_layers(const ChannelStages& channel, std::size_t step,
                                     const NeuralCodingParams& params);

// PBW[n] = sum_c w_c [channel c fires at n], of all samples that were coded.
std::vector<double> predicted_brain_waveform(const NeuralCode& code,
                                             const PerReceptor<double>& channel_weight);

// NC dissimilarity: root of the mean squared difference of two brain waveforms of as many samples.
double nc_dissimilarity(const NeuralCode& a, const NeuralCode& b,
                        const PerReceptor<double>& channel_weight);

}  // namespace tact
