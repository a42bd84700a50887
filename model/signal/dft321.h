// Acceleration along several axes as one signal that feels alike: the skin hardly tells directions
// of vibration apart.
//
//     |X(f)| = sqrt(sum_a |X_a(f)|^2),   arg X(f) = arg sum_a X_a(f)
//
// Source    DFT321: Landin, Romano, McMahan & Kuchenbecker 2010, "Dimensional reduction of
//           high-frequency accelerations for haptic rendering", with the phase of the sum
// Input     axes of one length, without their constant offset
// Output    as many samples; silence for none
// Valid     any number of axes; one comes out as it went in, but for rounding
// Left out  other choices of phase; blocks: the whole signal is one
// Exact     energy is kept: sum x^2 = sum_a sum x_a^2. Where the axes cancel, the phase is 0.
#pragma once

#include <span>
#include <vector>

namespace tact {

std::vector<double> dft321(std::span<const std::vector<double>> axes);

}  // namespace tact
