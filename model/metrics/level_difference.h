// R1: how much stronger one vibration is than another, and nothing else about them.
//
//     D = | 20 log10 RMS_x - 20 log10 RMS_y |
//
// Confidence  [H] ours, not from the paper: what intensity alone explains
// Input     two waveforms; their mean is no vibration and is left out
// Output    dB; silence counts as 1e-6 g, and so 117 dB below a sine of 1 g
#pragma once

#include <span>

namespace tact {

double level_db(std::span<const double> samples_g);  // over 1 g

double level_difference(std::span<const double> x_g, std::span<const double> y_g);

}  // namespace tact
