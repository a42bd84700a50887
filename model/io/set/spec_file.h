// What `generate` is told to make: a file with a generator alone, or a set file that has one.
//
// Output    errors as "FILE: PLACE: expected ..", PLACE a JSON pointer; syntax by line and column.
//           Remarks name keys of the generator that mean nothing.
#pragma once

#include <filesystem>

#include "model/common/expected.h"
#include "model/io/set/load.h"

namespace tact {

// A set with its generator; of a generator alone, a set without patterns named after the file.
Expected<Loaded> read_spec_file(const std::filesystem::path& path);

}  // namespace tact
