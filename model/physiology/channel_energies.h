// The energy that each channel perceives, by windows, from which the receptors' spikes are counted.
//
// The four channels filter one signal by the same number of sections, side by side in a register.
//
// Input     the vibration at 10 kHz, mean removed
// Output    C_j of each channel (spike_train.h): all zero if it is silent
// Left out  the filtered and the perceived waveform themselves: neural_coding_stages() has them.
// Exact     the bits of the channels one by one, on any instruction set.
#pragma once

#include <span>
#include <vector>

#include "model/physiology/neural_coding_params.h"
#include "model/signal/butterworth.h"

namespace tact {

// A channel's filter.
std::vector<Section> channel_sections(Receptor receptor, const NeuralCodingParams& params);

// `input_energy` is the sum of the squares of the input.
PerReceptor<std::vector<double>> channel_energy_fractions(std::span<const double> input_g,
                                                          double input_energy,
                                                          const NeuralCodingParams& params);

// The same with one of the processor's instruction sets, the fastest first.
struct ChannelRunner {
    const char* name;
    PerReceptor<std::vector<double>> (*run)(std::span<const double> input_g, double input_energy,
                                            const NeuralCodingParams& params);
};
std::span<const ChannelRunner> channel_runners();

}  // namespace tact
