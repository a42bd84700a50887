// Cutting a waveform to what is wanted of it: gain, trim, fades.
//
// Fades are halves of a raised cosine: (1 - cos(pi t / T)) / 2 from the first sample on, the same
// backwards to the end.
//
// Output    a waveform of the same rate
// Valid     any numbers: times are cut to the waveform; fades that meet are multiplied
#pragma once

#include "model/signal/waveform.h"

namespace tact {

Waveform with_gain(Waveform waveform, double gain);

// The part from one time up to another; none of it where they do not enclose any.
Waveform part_of(const Waveform& waveform, double begin_s, double end_s);

// So long after the beginning of a fade: from 0 to 1, and 1 behind it.
double fade_gain(double since_s, double length_s);

// 0 at the first sample and one beyond the last; 1 from `fade_in_s` to `fade_out_s` before the end.
Waveform faded(Waveform waveform, double fade_in_s, double fade_out_s);

}  // namespace tact
