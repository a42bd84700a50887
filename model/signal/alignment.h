// Where in a recording the pattern is that was played, and that part of it.
//
// The lag is the one at which the two signals correlate most, whichever sign the sensor has; among
// equals, as a steady tone has, the least.
//
// Input     a recording and its intended pattern, at one rate
// Output    the lag in whole samples; the recording from there on, as long as the pattern
// Valid     any lengths; silence on either side gives no lag
// Left out  fractions of a sample; several takes in one recording: the one most alike counts
// Exact     same input, same bits.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "model/signal/waveform.h"

namespace tact {

struct Alignment {
    std::ptrdiff_t lag = 0;          // the pattern's first sample is at this one of the recording
    double correlation = 0.0;        // 0..1: how alike the recording there and the pattern are
    double gain_db = 0.0;            // of the recording there against the pattern; 0: not known
    std::size_t missing_before = 0;  // samples the recording has not, and zeros stand for
    std::size_t missing_after = 0;
    Waveform waveform;  // as long as the pattern
};

Alignment aligned(const Waveform& recording, const Waveform& intended);

// Sentences on what a person should know: silence added, a recording unlike the pattern.
std::vector<std::string> remarks_on(const Alignment& alignment);

// What is less alike than this is hardly a recording of the pattern.
inline constexpr double kLeastAlike = 0.3;

// What differs more in strength may have been read in a wrong unit.
inline constexpr double kMostGainDb = 3.0;

}  // namespace tact
