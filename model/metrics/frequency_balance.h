// R5: how a vibration's power is shared between low and high frequencies, and nothing else of it.
//
//     B = 10 log10((P_high + e P) / (P_low + e P)),   D = |B_x - B_y|
//
// P_low is the power of the lines from 10 Hz to below 100 Hz, P_high of those from there to 1000
// Hz, P their sum, and e 1e-6, so that a single frequency is at 60 dB or at -60 dB.
//
// Confidence  [L] that this balance is what people go by in noisy vibrations of equal strength:
//           Bernard, Thoret, Huloux & Ystad 2023 (arXiv). The limits of the two bands, the dB and e
//           are ours, as only the abstract was at hand
// Input     spectrum of a waveform without its mean
// Output    dB; silence has a balance of 0
// Left out  strength, thresholds of feeling, and anything in time
#pragma once

#include "model/signal/spectrum.h"

namespace tact {

inline constexpr double kLowestBalanceHz = 10.0;
inline constexpr double kBalanceSplitHz = 100.0;
inline constexpr double kHighestBalanceHz = 1000.0;

double frequency_balance_db(const Spectrum& spectrum);

}  // namespace tact
