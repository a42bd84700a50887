// Many vibrations, one after the other or at once, as one amplitude and one frequency over time.
//
// Of several at once: the root of the sum of their squares, at the frequency of the strongest.
#pragma once

#include <vector>

#include "model/common/expected.h"
#include "model/io/effects/sketch.h"

namespace tact {

struct MergedVoices {
    AmplitudeCurve amplitude;  // g; from 0 s to the end of the whole, 0 between voices
    FrequencyCurve frequency;
    bool overlap = false;  // some of them sound at once
};

// Voices come in the order of their starts; `end_s` is the whole's. An Error has no file's name.
Expected<MergedVoices> merged(const std::vector<Voice>& voices, double end_s);

// When they begin, end and have points, ascending.
std::vector<double> times_of(const std::vector<Voice>& voices, bool amplitudes, bool frequencies);

// Whether two numbers were meant to be equal.
bool is_same(double a, double b);

}  // namespace tact
