// What a person works on: the set, where it is stored, and whether it is saved.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>

#include "model/set/pattern_set.h"

namespace tact {

struct Document {
    PatternSet set;
    std::filesystem::path path;  // empty: never saved
    PatternSet saved;            // as it was last read or written: unsaved means set != saved
    // Mark of the file's bytes at that time (app/session/document_file.h); empty: unknown.
    std::optional<std::uint64_t> file_mark{};
};

}  // namespace tact
