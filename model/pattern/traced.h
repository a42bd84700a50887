// A recording as a drawn pattern: one carrier, its amplitude and its strongest frequency as curves.
//
// Amplitude is that of a sine of equal energy, sqrt(2) rms, within 10 ms; a little more where that
// makes whole half cycles of the strongest frequency there, so that a steady tone comes out flat.
// The strongest frequency is the peak of a spectrum of 40 ms or four cycles (Hann window; a
// parabola through the logarithms of the three bins about it), wherever there is energy; elsewhere
// the curve is straight. Of a recording in which no such window fits, it is the one sine that
// explains most of it (least squares): a guess.
//
// Source    ours
// Input     a recording at any rate; between 20 and 1000 Hz there is something to be traced
// Output    a pattern that is as long, and how far its curves are from what was measured
// Valid     one strongest frequency at a time: of several at once it follows one
// Left out  phase, noise, further carriers, transients.
#pragma once

#include <cstddef>

#include "model/pattern/pattern.h"

namespace tact {

struct TraceParams {
    // Of each curve; fewer where all is within the tolerance of it already.
    std::size_t most_points = 60;
    double amplitude_tolerance = 0.01;  // of the largest amplitude
    double frequency_tolerance_hz = 1.0;
};

struct TracedPattern {
    Pattern pattern;
    double amplitude_error_g = 0.0;     // the largest, from the 10 ms envelope
    double frequency_error_hz = 0.0;    // the largest, from the strongest frequencies
    bool frequency_is_a_guess = false;  // too short to be measured: the error is not known
};

// No frequency curve where the frequency is steady; silence gives a pattern of 0 g without curves.
// Cut to the longest pattern there is, and to the strongest.
TracedPattern traced(const Waveform& recording, const TraceParams& params = {});

}  // namespace tact
