// The content of a folder, for a person to choose from.
//
// Output    folders and files by name, with the time of their last change; or an error as a
//           sentence
// Left out  hidden files, sizes.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace tact {

struct FolderEntry {
    std::string name;
    bool is_folder = false;
    std::string changed{};  // "2026-11-23 18:40", local time; empty: not known

    bool operator==(const FolderEntry&) const = default;
};

struct FolderListing {
    std::filesystem::path folder;
    std::vector<FolderEntry> entries;  // folders first, then in natural order: 2 before 10
    std::string fault;                 // the reason why there are no rows, a sentence
};

// Leaves out hidden files, and files without one of the extensions (".wav"; empty: all files).
FolderListing list_folder(const std::filesystem::path& folder,
                          const std::vector<std::string>& extensions);

// Whether the name has one of the extensions, case ignored; true without extensions.
bool has_extension(const std::string& name, const std::vector<std::string>& extensions);

// The home folder; the root if the environment does not tell.
std::filesystem::path home_folder();

// False also for a path that cannot be read.
bool is_folder(const std::filesystem::path& path);

}  // namespace tact
