// A vibration in g as a drive signal, where the actuator's response is not known.
//
// Output    samples / full_scale_g: strengths within a set stay in proportion, but what they become
//           in g depends on the actuator; show that as "uncalibrated"
// Left out  the actuator's response, which a calibration knows.
#pragma once

#include "devices/device/device.h"
#include "model/signal/waveform.h"

namespace tact {

// The acceleration that full scale is taken for unless a person says another. A choice of ours: at
// the low level that playing starts with, even 8 g stay below the limiter's ceiling.
inline constexpr double kFullScaleG = 1.0;

// `full_scale_g` above 0. Larger samples stay larger than 1: the device's limiter shows them.
Drive drive_of(const Waveform& waveform, double full_scale_g);

// A short sine to try a device with, with an onset of 10 ms, of full scale.
Drive test_buzz();

// How strong and for how long a drive may be: one law for whatever plays it.
//
// Input     what a person asks for, and what the drive itself says that it may come to
//           (devices/device/protection.h, devices/calibration/calibration.h)
// Left out  an output's own ceiling (devices/device/playback.h), and that of a coil
//           (devices/rumble).

// A share, 0 to 1. A level that is NaN becomes 0; a limit that is NaN is ignored.
double kept_level(double level, double largest_level = 1.0);

// How long a drive of `duration_s` plays on end, s: a loop without a limit for ever. A limit below
// 0 is 0; one that is NaN is ignored.
double kept_s(double duration_s, bool loop, double longest_s);

}  // namespace tact
