// A sound file as a named pattern, and all that is to be said of it: what the command and the
// window have in common.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "model/common/expected.h"
#include "model/io/effects/actuator_map.h"
#include "model/pattern/pattern.h"
#include "model/set/pattern_set.h"

namespace tact {

// How far a pattern is from the sound that it was made of, for who feels both: by PM.
//
// PM is of pairs among others: both are cut into sections as long as the patterns of a yardstick,
// and NC and OC of each section get the ranks that they would have among the yardstick's own pairs
// (model/export/ranks_among.h). So it says whether the two are farther apart than patterns that
// people can tell apart.
//
// Input     both at 10 kHz; a yardstick of three patterns and more
// Output    PM a section; 0 where the two are the same
// Left out  the first ms of a section, in which both are cut alike.
// Exact     same input, same bits, on any number of threads.

struct SoundMoved {
    std::string yardstick;  // the name of its set
    double section_s = 1.0;
    std::vector<double> pm;   // of each section
    double closest_pm = 0.0;  // of the yardstick's pairs ...
    double farthest_pm = 0.0;
};

struct SoundMovedOptions {
    int threads = 0;  // 0: all cores
    std::stop_token stop{};
    std::function<void(double)> progress{};  // 0..1, from any thread
};

// Nothing when stopped.
std::optional<SoundMoved> sound_moved(const Waveform& felt, const Pattern& pattern,
                                      const PatternSet& yardstick,
                                      const SoundMovedOptions& options = {});

// "PM from the sound 2.5 on the whole, at most 6 (3 to 4 s); the pairs of "PM 2023, twelve
// patterns" have 4 to 60": a sentence without its stop.
std::string words_on(const SoundMoved& moved);

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

// The actuator where nobody chooses.
inline constexpr const char* kUsualActuator = "core-haptics";

struct FromSoundOptions {
    ActuatorMap actuator = bundled_actuator(kUsualActuator);
    bool accents = true;
    // g that 1 of the sound stands for; default: the sidecar's, then the actuator's.
    std::optional<double> full_scale_g{};
    bool without_pm = false;
    int threads = 0;  // 0: all cores
    std::stop_token stop{};
    std::function<void(double)> progress{};  // 0..1, from any thread
};

struct FromSound {
    Vibration vibration;  // its name is the file's, its note what was done and lost
    SoundPattern made;
    double full_scale_g = 1.0;
    std::vector<std::string> remarks;  // on the file, then on what was lost: without their stop
    std::optional<SoundMoved> moved;   // none: not asked for
};

// Errors as read_sound_file, and where nothing of it lies in the band. PM is among the twelve
// patterns of Lim & Park 2023. Stopped: an Error that nobody needs to see.
Expected<FromSound> from_sound(const std::filesystem::path& path,
                               const FromSoundOptions& options = {});

}  // namespace tact
