// Strength over time as on-off times of a motor that has no amplitude: what a phone's browser can
// play.
//
// What is felt without a pause is a burst: above 8 % of full scale, silences of less than 10 ms
// included. Each begins with a pulse, at its own time, so that a rhythm stays one. Within it the
// amplitude is the share of time that the motor runs, in pulses of at least 15 ms and pauses of at
// least 10: up to 60 % of full scale 15 ms on, above that 10 ms off, from 95 % on no pause. What a
// pulse gives too much or too little is carried on to the next one (error diffusion), within a
// burst alone: the same note is the same wherever it stands.
//
// Source    the form: navigator.vibrate of the W3C's Vibration API (on, off, on .. in whole ms).
//           Limits: Chromium's vibration_controller.cc, which cuts the rest off.
// Guessed   15 and 10 ms, 8 and 95 %: motors of phones are commonly said to take 10 to 50 ms to
//           come up to strength; these are choices within that, not confirmed on any device.
// Output    entries in turns, on first, 0 if it begins with silence; their sum is the length to the
//           ms, but 15 ms where there is something to feel in less; the time on is that of the
//           amplitudes within a pulse for each burst; same input, same entries
// Valid     any numbers: NaN, infinities and negative ones are silence; rates of 1 Hz to 1 GHz
// Left out  the limits of one call: the page cuts what is longer, and a writer of files.
#pragma once

#include <span>
#include <vector>

#include "model/io/effects_out/stepped.h"

namespace tact {

inline constexpr int kLeastOnMs = 15;
inline constexpr int kLeastOffMs = 10;

// The limits of one call of navigator.vibrate in Chrome.
inline constexpr std::size_t kMostVibrateEntries = 99;
inline constexpr int kLongestVibrateMs = 10'000;

struct OnOff {
    std::vector<int> ms;
    double floor_lost_s = 0.0;  // what was too weak, or too close behind another, to be felt
    int lengthened = 0;         // bursts of less than 15 ms, which are 15 ms now

    bool operator==(const OnOff&) const = default;
};

// Amplitudes of 0 to 255. `coarser`: the factor by which pulses and pauses within a burst are
// longer, where fewer entries are needed; the notes of a rhythm stay as they are.
OnOff on_off_of(const SteppedAmplitudes& steps, int coarser = 1);

// The same for a drive of -1 to 1, played at a level: the greatest of each ms, where what is weaker
// for less than 10 ms, such as the zeros of a tone from 50 Hz on, counts as what is around it.
OnOff on_off_of_drive(std::span<const double> samples, double rate_hz, double level);

}  // namespace tact
