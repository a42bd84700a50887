// What the receptors' spikes are counted from: the energy that each channel perceives, by windows.
//
// The four channels filter one signal by as many sections, side by side in a register.
//
// Input     the vibration at 10 kHz, mean removed
// Output    C_j of each channel (spike_train.h): all zero where it is silent
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

// The same by one of the instruction sets this processor has, the fastest first.
struct ChannelRunner {
    const char* name;
    PerReceptor<std::vector<double>> (*run)(std::span<const double> input_g, double input_energy,
                                            const NeuralCodingParams& params);
};
std::span<const ChannelRunner> channel_runners();

}  // namespace tact
