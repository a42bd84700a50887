// A recording of a pattern of a set, from its file to the twin beside the pattern: the question of
// the window's import and of the command line's.
//
// Source    model/io/recordings/acceleration_file.h, model/set/measured_twin.h
// Output    a twin that is in no set yet, and has no file: insert_twin(), store_measurements()
// Exact     same file, same bits, but for recordings at another rate than 10 kHz (soxr).
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "model/common/expected.h"
#include "model/io/recordings/acceleration_file.h"
#include "model/set/measured_twin.h"
#include "model/set/pattern_set.h"

namespace tact {

struct ReadTwin {
    std::optional<Twin> twin;          // none where no pattern was named
    std::vector<std::string> remarks;  // on the file, then on how the two were aligned
};

// `place`: of the pattern that the file measures; none: not known yet. `files`: all that are read
// together, among which it has its own channel or unit (options_among). Errors: a file that cannot
// be read; a pattern that is a measurement itself.
Expected<ReadTwin> read_twin(const PatternSet& set, std::optional<std::size_t> place,
                             const std::filesystem::path& file,
                             std::span<const std::filesystem::path> files,
                             const AccelerationOptions& options);

}  // namespace tact
