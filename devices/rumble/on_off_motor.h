// A motor that is only ever on or off, at one frequency: a phone's, as a browser switches it.
//
// Its strength goes to the whole one while it is on and to nothing while it is off (first order),
// so that short pulses are weaker than long ones, and a row of them is about as strong as the share
// of time that it is on.
//
// Source    own choices from what motors of phones usually do: GUESSED, not confirmed on a device.
// Input     on-off times as model/io/effects_out/on_off.h has them
// Output    samples, 1 at full strength; what is behind the last time fades
// Left out  differences between phones, the time from the call to the motor, brakes, what a hand
//           and a case do to it, frequencies that follow the strength.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace tact {

struct OnOffMotor {
    double frequency_hz = 165.0;
    double rise_s = 0.025;  // time constant while it is on ...
    double fall_s = 0.025;  // ... and while it is off
};

// GUESSED: named so, and labelled "uncalibrated" and "a guess" wherever it is shown.
inline constexpr OnOffMotor kGuessedPhoneMotor{165.0, 0.025, 0.025};

std::vector<double> shaken_by(const OnOffMotor& motor, std::span<const int> ms, double rate_hz,
                              std::size_t samples);

}  // namespace tact
