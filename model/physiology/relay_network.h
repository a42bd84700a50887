// The relay network between skin and cortex: excitatory layers spread activity, inhibitory ones
// sharpen it.
//
// Source    Lim & Park 2023, section 4.3, Eqs. 5 and 6.
// Input     spike counts of one 5 ms step at the receptors' places on the grid
// Output    every layer; the centre cell of the last is what reaches the cortex
// Left out  delays, memory between steps, subcortical stations by name.
#pragma once

#include <vector>

#include "model/physiology/neural_coding_params.h"

namespace tact {

// A square of (2 half_width + 1)^2 cells around the centre, row by row; zero outside.
struct RelayLayer {
    int half_width = 0;
    std::vector<double> cells{0.0};

    double at(int column, int row) const;
    double& cell(int column, int row);
    double centre() const { return at(0, 0); }
};

RelayLayer empty_layer(int half_width);

// L_E excitatory layers, each one cell wider than the last, then L_I inhibitory ones of the same
// size; cells are clipped to 0..cap. The result has L_E + L_I layers.
//
// With `cone_only` only the cells that can still reach the centre are computed. Their values are
// the same to the bit, because activity moves one cell per layer.
std::vector<RelayLayer> relay(const RelayLayer& spikes, const NeuralCodingParams& params,
                              bool cone_only);

}  // namespace tact
