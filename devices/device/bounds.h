// How strong and for how long a drive may be: one law for whatever plays it.
//
// Input     what a person asks for, and what the drive itself says that it may come to
//           (devices/device/protection.h, devices/calibration/calibration.h)
// Left out  an output's own ceiling (devices/device/playback.h), and that of a coil
//           (devices/rumble).
#pragma once

namespace tact {

// A share, 0 to 1. A level that is NaN becomes 0; a limit that is NaN is ignored.
double kept_level(double level, double largest_level = 1.0);

// How long a drive of `duration_s` plays on end, s: a loop without a limit for ever. A limit below
// 0 is 0; one that is NaN is ignored.
double kept_s(double duration_s, bool loop, double longest_s);

}  // namespace tact
