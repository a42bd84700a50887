// What keeps a drive signal from harming an actuator whose limits nobody has measured.
//
// Without a calibration nobody knows how far an actuator moves, or what it bears. Hence
//   - nothing much below 20 Hz: at a constant acceleration the excursion grows as 1 / f^2
//     (a soft edge from 16 to 12 Hz, as a short tone of 20 Hz reaches down there)
//   - a ramp of 5 ms at the start and at the end, which a coil takes for a blow otherwise
//   - no longer than a minute on end, for the heat
// A calibration knows better: devices/calibration/calibration.h holds back by what it says.
//
// Source    choices of ours; 1 g is 0.6 mm at 20 Hz and 250 mm at 1 Hz
// Output    the drive as long as before; from 16 Hz up as it was, but for the ramps. One that has
//           less than 2 % of its energy below is not filtered: a sudden start alone reaches down
//           there. What is no number is silence.
// Left out  ramps of a loop, whose seam is its own; the heat of plays with pauses between them.
#pragma once

#include <string>

#include "devices/device/device.h"

namespace tact {

inline constexpr double kLongestOnEndS = 60.0;

struct ProtectedDrive {
    Drive drive;
    std::string remark;  // "loses ..." without a subject and a full stop; empty: as it was meant
};

// `is_on` false: the drive as it is. `longest_s`: on end, above 0.
ProtectedDrive protected_drive(const Drive& drive, bool loop, bool is_on,
                               double longest_s = kLongestOnEndS);

}  // namespace tact
