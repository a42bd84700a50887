// Folders to write into.
#pragma once

#include <filesystem>

#include "model/common/expected.h"

namespace tact {

// False also where it cannot be known.
bool is_there(const std::filesystem::path& path);

// The folder, made with its parents where it is missing.
Expected<Done> make_folder(const std::filesystem::path& folder);

}  // namespace tact
