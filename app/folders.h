// Folders to write into.
#pragma once

#include <filesystem>

#include "model/expected.h"

namespace tact {

// The folder, made with its parents where it is missing.
Expected<Done> make_folder(const std::filesystem::path& folder);

}  // namespace tact
