// Where a calibration signal begins in a recording of it, and how fast the recording's clock runs.
//
// At each frequency of the plan, how strong the recording is over time, in windows of 0.1 s, is
// correlated with how strong the plan is, at every lag; the mean over the frequencies tells the
// lag. A resonance makes a frequency stronger as a whole, of which its correlation knows nothing.
//
// Source    a spectrogram's correlation, each row by itself; the least one: a choice of ours. Noise
//           reaches 0.05, the plan at another lag 0.2.
// Output    the first sample of the plan, to a hundredth of a second; none where it is not
// Left out  two plays of the plan, but for the latest.
#pragma once

#include <cstddef>
#include <optional>
#include <span>

#include "devices/calibration/calibration_run.h"

namespace tact {

// By how much the recording's clock is off, as a share: 0.01 where what lasted a second fills 1 %
// less of the recording, in which all frequencies are 1 % higher. Sought to either side as long as
// that makes the recording more like the plan, up to kMostClockOff; to a thousandth or so.
double clock_off_of(const CalibrationPlan& plan, std::span<const double> samples);

inline constexpr double kMostClockOff = 0.035;

// `samples` at the plan's rate, at least as long as it. `latest`: where it is there several times,
// as weaker sweeps before the last are.
std::optional<std::size_t> place_of_plan(const CalibrationPlan& plan,
                                         std::span<const double> samples, bool latest = false);

}  // namespace tact
