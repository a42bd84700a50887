// What reading a file or a folder gives: the set, what was odd but accepted, and what was left out.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "model/io/effects/actuator_map.h"
#include "model/set/pattern_set.h"

namespace tact {

// All recordings of a set in memory: 10,000 of one second, 0.8 GB.
inline constexpr std::size_t kMaxSetSamples = 100'000'000;

std::size_t recorded_samples(const Vibration& vibration);
std::size_t recorded_samples(const PatternSet& set);

// What is wrong with this number of samples, as the end of a sentence; or empty.
std::string samples_fault(std::size_t samples);

struct Loaded {
    PatternSet set;
    std::vector<std::string> remarks;  // sentences: resampled, first channel used, padded ..
    bool effects = false;              // of another program: names may change to be unique
    std::size_t files = 1;             // that were read
    // Files of a folder that could not be read, each as "FILE: what was expected".
    std::vector<std::string> left_out{};
};

// "35 files read, 7 not"; empty where nothing was left out.
std::string counts_text(const Loaded& loaded);

struct LoadOptions {
    std::optional<ActuatorMap> actuator{};  // default: each format's own
    bool partly = false;  // of several paths, those that cannot be read are left out
    std::stop_token stop{};
    std::function<void(double share)> progress{};  // on the reading thread
};

inline constexpr const char* kReadingCancelled = "reading was cancelled";

}  // namespace tact
