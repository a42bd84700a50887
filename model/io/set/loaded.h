// What reading a file gives: the set, and what was odd about the file but accepted.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "model/set/pattern_set.h"

namespace tact {

// Of all recordings of a set, in memory: 10,000 of one second, 0.8 GB.
inline constexpr std::size_t kMaxSetSamples = 100'000'000;

std::size_t recorded_samples(const Vibration& vibration);
std::size_t recorded_samples(const PatternSet& set);

// What is wrong with so many, as the end of a sentence; or empty.
std::string samples_fault(std::size_t samples);

struct Loaded {
    PatternSet set;
    std::vector<std::string> remarks;  // sentences: resampled, first channel used, padded ..
    bool effects = false;              // of another program: names may change to be unique
};

}  // namespace tact
