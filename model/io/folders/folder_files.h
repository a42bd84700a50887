// The files of a folder or of a zip file, and of the folders in it, wherever their bytes are.
//
// Output    paths, of a zip file's as if it were a folder; what cannot be read is left out with its
//           reason, as "FILE: what was expected"
// Valid     kMostEntries files and folders to look at, kMostDepth folders deep
// Left out  hidden files; the measured/ folder beside a set, which holds that set's recordings;
//           links to folders
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <stop_token>
#include <string>
#include <vector>

#include "model/common/expected.h"

namespace tact {

inline constexpr std::size_t kMostEntries = 100'000;
inline constexpr int kMostDepth = 16;

// How files are read: from the disk, or out of a zip file.
struct FileAccess {
    std::function<std::string(const std::filesystem::path&)> head;  // empty: it cannot be read
    std::function<std::size_t(const std::filesystem::path&)> size;
    std::function<bool(const std::filesystem::path&)> is_there;
    std::function<Expected<std::string>(const std::filesystem::path&, std::size_t most_bytes)>
        bytes;
    std::filesystem::path zip{};  // they lie in; empty: on the disk
};

FileAccess files_on_disk();

// Where a file is: on the disk, or in the zip file that its path leads through.
FileAccess access_to(const std::filesystem::path& file);

struct FolderFiles {
    std::vector<std::filesystem::path> files;  // in no order
    std::vector<std::string> left_out;
    FileAccess access;
};

bool is_set_name(const std::filesystem::path& path);

// An Error where there is too much, and where it was stopped.
Expected<FolderFiles> files_below(const std::filesystem::path& folder_or_zip,
                                  const std::stop_token& stop = {});

// Folders to write into.

// False also where it cannot be known.
bool is_there(const std::filesystem::path& path);

// The folder, made with its parents where it is missing.
Expected<Done> make_folder(const std::filesystem::path& folder);

}  // namespace tact
