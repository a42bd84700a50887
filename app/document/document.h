// What a person works on: the set, where it is stored, and whether it is saved.
#pragma once

#include <filesystem>

#include "model/set/pattern_set.h"

namespace tact {

struct Document {
    PatternSet set;
    std::filesystem::path path;  // empty: never saved
    PatternSet saved;            // as it was last read or written: unsaved means set != saved
};

}  // namespace tact
