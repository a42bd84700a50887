// What a pad's two motors, or an actuator with an intensity alone, are told for a vibration: its
// strength over time, as a motor can follow it.
//
// A motor with an off-centre mass shakes with w^2, w its speed: for an envelope e the speed is
// sqrt(e). Below the dead zone u0 it does not turn, so the duty is u0 + (1 - u0) sqrt(e). Its speed
// lags behind the duty (first order); full duty while it is too slow and none while it is too fast
// bring it there sooner. A level scales the envelope, before the root and the dead zone: at a tenth
// the motor shakes a tenth as strongly, and patterns keep their proportions.
//
// What the filters leave of a tone half an octave from the split is a quarter of it on the other
// side, and a quarter of a strength is half of a speed. So a quarter of the other band is taken off
// each, as power: tones farther from the split than that drive one motor alone.
//
// Source    the square law: centripetal force; all numbers below: own choices from what pads of
//           this kind usually do, none measured.
// Input     a drive signal, -1..1
// Output    frames with low: the strong motor or the intensity, high: the weak motor; duties, 0..1
// Valid     frequencies are not kept: a motor's follows its strength
// Left out  differences between pads, stiction, the battery.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "devices/device/device.h"
#include "devices/rumble/rumble_packets.h"

namespace tact {

struct Motor {
    double full_speed_hz = 60.0;
    double rise_s = 0.06;  // time constant towards a higher speed ...
    double fall_s = 0.09;  // ... and coasting
    double dead_zone = 0.15;
};

inline constexpr Motor kStrongMotor{60.0, 0.06, 0.09, 0.15};
inline constexpr Motor kWeakMotor{160.0, 0.04, 0.06, 0.15};

// Where the signal is split between the two.
inline constexpr double kMotorSplitHz = 110.0;

// Speed as a share of the full one, after `step_s` at a duty.
double speed_after(const Motor& motor, double speed, double duty, double step_s);

// Strength over time, as the amplitude of a sine that is as strong: one value a hop, the largest
// within it.
std::vector<double> envelope(std::span<const double> signal, double rate_hz, double hop_s);

// The signal below `edge_hz`, not delayed: a fourth-order fall, run forwards and backwards.
std::vector<double> below(std::span<const double> signal, double edge_hz, double rate_hz);

// Duties that bring a motor's strength to an envelope times a level, one a hop.
std::vector<double> motor_duties(const Motor& motor, std::span<const double> envelope, double hop_s,
                                 double level = 1.0);

// Strengths over time of what each of two motors is to shake, one value a hop; of an intensity
// alone all is `low`.
struct Strengths {
    std::vector<double> low;
    std::vector<double> high;
};

Strengths motor_pair_strengths(const Drive& drive, double hop_s);
std::vector<RumbleFrame> motor_pair_frames(const Strengths& strengths, double hop_s, double level);

// The whole envelope. Starts where it rises above 5 % of full scale and ends where it falls below
// 3 %, so that a faint end does not flutter: at any level, so that a low one leaves nothing out.
Strengths intensity_strengths(const Drive& drive, double hop_s);
std::vector<RumbleFrame> intensity_frames(const Strengths& strengths, double level);

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
