// What keeps a drive signal from harming an actuator whose limits nobody has measured.
//
// Without a calibration nobody knows how far an actuator moves, or what it bears. Hence
//   - a high-pass, as at a constant acceleration the excursion grows as 1 / f^2: with f in Hz
//         gain = 1                              from 16 Hz up
//                (1 - cos(pi (f - 7) / 9)) / 2  between; at 10 Hz 1/4, or -12 dB
//                0                              up to 7 Hz
//     of zero phase, and the same for every drive, however little of it is slow: patterns of one
//     set are treated alike. The edge is as soft as lets no more than 1/4 pass below 10 Hz.
//   - a ramp of 5 ms at the start and at the end, which a coil takes for a blow otherwise
//   - no longer than a minute on end, for the heat, whether in one play or in many in turn
//     (devices/device/ledger.h)
// A calibration knows better: devices/calibration/calibration.h holds back by what it says.
//
// Source    choices of ours; 1 g is 0.6 mm at 20 Hz and 250 mm at 1 Hz
// Output    the drive as long as before; one below 0.3 s that loses a part has 0.1 s more at either
//           end, for the filter's ring, and says so as its lead and tail. What lies above 16 Hz as
//           it was, but for the ramps. A sudden start reaches below, and loses that: within 0.1 s
//           of it a tone of 20 Hz changes by up to a quarter of its peak, one of 150 Hz by 3 %.
//           What is no number is silence.
// Left out  ramps of a loop, whose seam is its own.
#pragma once

#include <optional>
#include <string>

#include "devices/device/device.h"

namespace tact {

inline constexpr double kLongestOnEndS = 60.0;

struct ProtectedDrive {
    Drive drive;
    std::string remark;  // "loses ..." without a subject and a full stop; empty: as it was meant
};

// `is_on` false: the drive unchanged. `longest_s`: on end, above 0; it holds where protection is
// off as well. Default: kLongestOnEndS where that is on.
ProtectedDrive protected_drive(const Drive& drive, bool loop, bool is_on,
                               std::optional<double> longest_s = {});

}  // namespace tact
