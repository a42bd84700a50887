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
#pragma once

#include <functional>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "model/set/pattern_set.h"

namespace tact {

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

}  // namespace tact
