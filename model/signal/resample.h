// The same vibration at another sampling rate.
//
// Source    libsoxr, its "very high quality" recipe (linear phase, 28 bits).
// Output    round(N rate / old rate) samples, not delayed: sample n is at n / rate as before
// Valid     rates of 100 Hz to 10 MHz. Within some ms of either end the filter sees the silence
//           beyond; what lies above half the lower rate is gone.
// Left out  other qualities, streaming.
// Exact     same bits on one machine; another instruction set may change the last ones.
#pragma once

#include "model/signal/waveform.h"

namespace tact {

inline constexpr double kLowestRateHz = 100.0;
inline constexpr double kHighestRateHz = 10e6;

// The waveform itself where it already has the rate.
Waveform resampled(const Waveform& waveform, double rate_hz);

}  // namespace tact
