// Anything a person names as a set: a set file, a folder of recordings, a recording.
#pragma once

#include <filesystem>
#include <span>
#include <vector>

#include "model/common/expected.h"
#include "model/io/set/loaded.h"

namespace tact {

// By kind: a folder (its .txt and .wav files), .json (a set file), .txt and .wav (a set of one).
Expected<Loaded> load_set(const std::filesystem::path& path);

// Several as one. Name, duration, model parameters and unknown keys are those of the first; two
// vibrations of one name are an Error. No path gives an Error.
Expected<Loaded> load_sets(std::span<const std::filesystem::path> paths);

}  // namespace tact
