// Folders to write into, and what is in them.
#pragma once

#include <filesystem>
#include <string>

#include "model/io/folders/new_folder.h"

namespace tact {

// Takes the folder and every file in it, old ones too, from all other users. A file whose
// permissions cannot be changed keeps them.
void keep_private(const std::filesystem::path& folder);
inline constexpr unsigned kPrivateFile = 0600;

// A name by the time of the clock on the wall, such as recovered-20260131-235959.json, or with -2,
// -3 ...: never one that is there.
std::filesystem::path unused_file(const std::filesystem::path& folder, const std::string& prefix,
                                  const std::string& ending);

}  // namespace tact
