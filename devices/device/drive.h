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

}  // namespace tact
