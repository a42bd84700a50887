// Anything a person names as a set: a set file, a folder of recordings and effects, a recording, an
// effect of another program.
#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <vector>

#include "model/common/expected.h"
#include "model/io/effects/actuator_map.h"
#include "model/io/set/loaded.h"

namespace tact {

// By kind: a folder or zip file (its .txt and .wav files and effects), .txt and .wav (a set of
// one), a set file, and by its content an effect file (model/io/effects/read_effects.h), whose
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
