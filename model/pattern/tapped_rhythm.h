// A rhythm from taps.
//
// The step is the shortest interval between taps, or the largest whole part of it, for which the
// taps are on the grid (rms within an eighth of a step), half of the notes are half a step or
// longer, and what was let go before the next tap leaves a rest. It is fitted to all onsets by
// least squares.
//
// Source    ours
// Input     taps in order, each let go before the next
// Valid     unsteady taps get the part of the interval that fits best
// Left out  tempo that changes.
#pragma once

#include <cstddef>
#include <span>

#include "model/pattern/rhythm.h"

namespace tact {

struct Tap {
    double onset_s = 0.0;
    double length_s = 0.0;
};

// 0.125 s where there are not two taps.
double estimated_step_s(std::span<const Tap> taps);

struct TappedRhythm {
    Rhythm rhythm;             // from the first tap on, rests to fill `least_s`
    double length_s = 0.0;     // of the text, without those rests
    double rms_error_s = 0.0;  // of the onsets, from the grid that fits them best
    std::size_t left_out = 0;  // taps of one step with the one before, or beyond the longest text
};

// Empty text for no taps.
TappedRhythm tapped_rhythm(std::span<const Tap> taps, double step_s, double least_s);

}  // namespace tact
