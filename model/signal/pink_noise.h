// Pink noise to mask the sound of an actuator: equal power in every octave, and no seam where it
// starts again.
//
// Source    white noise through one-pole filters an octave apart, each with its zero half an octave
//           above the pole: -3 dB an octave between 20 Hz and 0.4 of the rate, within 0.5 dB.
// Output    samples within -1..1 whose largest is 1
// Exact     same seed, same samples.
#pragma once

#include <cstdint>
#include <vector>

namespace tact {

// `seconds` of noise at a rate; a loop of them has no seam. Empty for none.
std::vector<double> pink_noise(double rate_hz, double seconds, std::uint64_t seed);

}  // namespace tact
