// A sound as a parametric pattern for an actuator: what is left of it in the actuator's band, as
// one carrier with an envelope and a frequency, and accents.
//
// The sound as it would be felt is filtered without delay: all of the band, and a sixth of an
// octave beside it; from there on it fades within half an octave. That is traced
// (model/pattern/traced.h) in sections of 1 s. A gain of the sound is a gain of the pattern and
// nothing else.
//
// Source    ours
// Input     a sound at 10 kHz, 1 being full scale
// Output    a pattern as long as the sound, and what it leaves out
// Valid     1 ms to 60 s
// Left out  the actuator's response within its band; what a lower pitch would keep of a high sound.
// Exact     same input, same bits, on any machine and number of threads.
#pragma once

#include <string>
#include <vector>

#include "model/pattern/pattern.h"

namespace tact {

struct SoundOptions {
    Range band_hz{65.0, 300.0};
    double full_scale_g = 1.0;  // that 1 of the sound stands for
    bool accents = true;
    std::size_t points_per_s = 60;  // of each curve, at most
};

struct SoundPattern {
    Pattern pattern;
    Waveform felt;  // the sound in the band, in g
    // Shares of energy: of the sound, what lies outside of the band; of what is in it, what has
    // other frequencies than the strongest.
    double outside_share = 0.0;
    double other_share = 0.0;
    double amplitude_error_g = 0.0;   // the largest, of the points, from the envelope
    double frequency_error_hz = 0.0;  // the largest, from the strongest frequencies
    bool frequency_is_a_guess = false;
    double over_g = 0.0;  // the peak of what is above full scale, or 0
};

// As it would be felt on an actuator of that band.
Waveform felt_in_band(const Waveform& sound, Range band_hz);

SoundPattern pattern_of_sound(const Waveform& sound, const SoundOptions& options = {});

// What was lost, and what was kept, in sentences without their stop; the most important last.
std::vector<std::string> words_of(const SoundPattern& made, const SoundOptions& options);

}  // namespace tact
