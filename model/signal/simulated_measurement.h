// What an accelerometer on an actuator might record: for teaching and testing, never evidence.
//
// The actuator is a mass on a spring and a damper, driven by a force; its acceleration against the
// drive is
//     H(s) = gain s^2 / (s^2 + s w0 / Q + w0^2),
// Q times the gain at its resonance, the gain far above, falling by f^2 below.
//
// Source    second-order resonance of any textbook; bilinear transform, exact at the resonance
// Input     the drive in g at any rate above twice the resonance
// Output    as many samples and those of the onset and of ringing down after
// Left out  distortion, an amplifier, the skin's load, direction, filters of the sensor
// Exact     same seed, same bits.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "model/common/units.h"
#include "model/signal/waveform.h"

namespace tact {

struct ActuatorParams {
    double resonance_hz = 80.0;  // the default is a choice of ours, no product's
    double q = 2.0;
    double gain = 1.0;      // far above the resonance, g/g
    double onset_s = 0.02;  // from the drive's begin to the motion's
    double noise_g = 0.01;  // of the sensor, rms
    std::uint64_t seed = 1;

    bool operator==(const ActuatorParams&) const = default;
};

namespace limits {
inline constexpr Range kResonanceHz{1.0, 2000.0};
inline constexpr Range kResonanceQ{0.1, 100.0};
inline constexpr Range kActuatorGain{0.0, 100.0};
inline constexpr Range kOnsetS{0.0, 1.0};
inline constexpr Range kSensorNoiseG{0.0, 10.0};
}  // namespace limits

Waveform simulated_measurement(const Waveform& drive, const ActuatorParams& params);

// Acceleration along several axes as one signal that feels alike: the skin hardly tells directions
// of vibration apart.
//
//     |X(f)| = sqrt(sum_a |X_a(f)|^2),   arg X(f) = arg sum_a X_a(f)
//
// Source    DFT321: Landin, Romano, McMahan & Kuchenbecker 2010, "Dimensional reduction of
//           high-frequency accelerations for haptic rendering", with the phase of the sum
// Input     axes of one length, without their constant offset
// Output    as many samples; silence for none
// Valid     any number of axes; one comes out as it went in, but for rounding
// Left out  other choices of phase; blocks: the whole signal is one
// Exact     energy is kept: sum x^2 = sum_a sum x_a^2. Where the axes cancel, the phase is 0.

std::vector<double> dft321(std::span<const std::vector<double>> axes);

}  // namespace tact
