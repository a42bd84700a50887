// Anything a person names as a set: a set file, a folder of recordings and effects, a recording, an
// effect of another program.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <stop_token>
#include <string>
#include <vector>

#include "model/common/expected.h"
#include "model/io/effects/actuator_map.h"
#include "model/set/pattern_set.h"

namespace tact {

// What reading a file or a folder gives: the set, what was odd but accepted, and what was left out.

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
    std::optional<std::uint64_t> mark{};  // fingerprint of a set file's bytes, as they were read
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

// By kind: a folder or zip file (its .txt and .wav files and effects), .txt and .wav (a set of
// one), a set file, and by its content an effect file (model/io/formats/read_effects.h), whose
// shares become g and Hz by `actuator` (default: its format's map).
Expected<Loaded> load_set(const std::filesystem::path& path,
                          const std::optional<ActuatorMap>& actuator = {});
Expected<Loaded> load_set(const std::filesystem::path& path, const LoadOptions& options);

// Whether a file reads as effects of another program: what is made of it is not to be saved over
// it.
bool holds_effects(const std::filesystem::path& path);

// Several as one. Name, duration, model parameters and unknown keys are those of the first; two
// vibrations of one name are an Error, but that an effect gets a name that is free. Two files of an
// AHAP pair among them are one effect. No path gives an Error.
//
// With `partly`, what cannot be read, or not beside the others, is left out, and recordings and
// folders may get names that are free as well; an Error where nothing could be read.
Expected<Loaded> load_sets(std::span<const std::filesystem::path> paths,
                           const std::optional<ActuatorMap>& actuator = {});
Expected<Loaded> load_sets(std::span<const std::filesystem::path> paths,
                           const LoadOptions& options);

}  // namespace tact
