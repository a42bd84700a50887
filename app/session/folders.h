// Folders to write into, and what is in them.
#pragma once

#include <filesystem>
#include <string>

#include "model/common/expected.h"

namespace tact {

// False also where it cannot be known.
bool is_there(const std::filesystem::path& path);

// The folder, made with its parents where it is missing.
Expected<Done> make_folder(const std::filesystem::path& folder);

// The folder and all in it are of this user alone: what is there from before, too. What cannot be
// made so stays as it is.
void keep_private(const std::filesystem::path& folder);
inline constexpr unsigned kPrivateFile = 0600;

// A name by the time of the clock on the wall, such as recovered-20260131-235959.json, or with -2,
// -3 ...: never one that is there.
std::filesystem::path unused_file(const std::filesystem::path& folder, const std::string& prefix,
                                  const std::string& ending);

}  // namespace tact
