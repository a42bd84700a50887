// Strength over time as steps of one amplitude each, 0 to 255: what motors without a frequency of
// their own are told.
//
// What is flat is one step, rounded to a whole ms and to 1/255, silence 0. A slope from its first
// value to its last is in steps of `step_s`: truncated in single precision, never 0, as a motor
// that stops and starts is heard. Neighbours of one amplitude are one step.
//
// Source    Meta's converter and its tests, for slopes: steps of one length, the last one shorter,
//           amplitudes truncated to 1 to 255
// Valid     curves of 0 to 1, by time; at least 1 ms comes out, as players refuse less
#pragma once

#include <vector>

#include "model/pattern/curves.h"

namespace tact {

struct SteppedAmplitudes {
    std::vector<int> timings_ms;
    std::vector<int> amplitudes;
};

SteppedAmplitudes stepped(const AmplitudeCurve& intensity, double duration_s, double step_s);

// Whether it is flat between its jumps: then the steps hold it.
bool is_staircase(const AmplitudeCurve& curve);

}  // namespace tact
