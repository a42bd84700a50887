// A recording of a calibration signal with the clock that the signal had, and where it begins.
//
// What a sensor says of its rate may be off by percents. The signal is known: how fast the clock is
// shows in how the phase of steady tones runs on, and in how much later than it should each part of
// a sweep fits. Each is taken out and looked at again.
//
// Output    none: the signal is not there, or the clock is off by more than kMostClockOff
// Exact     a clock to 1e-4; less than 5e-4 (tones) or 2e-3 (sweep) is left, as it does no harm
// Left out  a clock that drifts.
#pragma once

#include <cstddef>
#include <optional>

#include "devices/calibration/calibration_run.h"
#include "model/signal/waveform.h"

namespace tact {

struct AlignedRecording {
    Waveform recorded;       // at the plan's rate
    std::size_t start = 0;   // of the plan
    double clock_off = 0.0;  // that was taken out, as a share; above 0: all was too high
};

std::optional<AlignedRecording> aligned_recording(const CalibrationPlan& plan,
                                                  const Waveform& recorded);

}  // namespace tact
