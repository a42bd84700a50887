// A recording as a drawn pattern: one carrier, its amplitude and its strongest frequency as curves.
//
// Amplitude is that of a sine of equal energy, sqrt(2) rms, within 10 ms; a little more where that
// makes whole half cycles of the strongest frequency there, so that a steady tone comes out flat.
// The strongest frequency is the peak of a spectrum of 40 ms or four cycles (Hann window; a
// parabola through the logarithms of the three bins about it), wherever there is energy; elsewhere
// the curve is straight. If no such window fits a recording, it is the one sine that explains most
// of it (least squares): a guess.
//
// Where it is asked for, what lasts less than 60 ms becomes transients
// (model/signal/short_bursts.h), each of the strongest frequency in it, and the curves are those of
// what is left. A longer recording has its points section by section; sections share the point
// between them.
//
// Source    ours
// Input     a recording at any rate; between 20 and 1000 Hz there is something to be traced
// Output    a pattern that is as long, and how far its curves are from what was measured
// Valid     one strongest frequency at a time: it follows one of several
// Left out  phase, noise, further carriers; transients by default.
#pragma once

#include <cstddef>

#include "model/pattern/pattern.h"

namespace tact {

struct TraceParams {
    // Most points of each curve; fewer if all is within the tolerance already.
    std::size_t most_points = 60;
    double amplitude_tolerance = 0.01;  // of the largest amplitude
    double frequency_tolerance_hz = 1.0;
    double section_s = 0.0;       // the stretch that has `most_points`; 0: the whole
    Range band_hz{20.0, 1000.0};  // where the strongest frequency is looked for
    bool transients = false;
};

struct TracedPattern {
    Pattern pattern;
    double amplitude_error_g = 0.0;     // the largest, from the 10 ms envelope
    double frequency_error_hz = 0.0;    // the largest, from the strongest frequencies
    bool frequency_is_a_guess = false;  // too short to be measured: the error is not known
    // Share of the energy that is more than two bins (50 Hz at 40 ms) off the strongest frequency,
    // where one was measured: other frequencies, and noise.
    double other_share = 0.0;
};

// No frequency curve where the frequency is steady; silence gives a pattern of 0 g without curves.
// Cut to the longest pattern there is, and to the strongest.
TracedPattern traced(const Waveform& recording, const TraceParams& params = {});

}  // namespace tact
