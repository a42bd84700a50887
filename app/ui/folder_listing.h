// What of a folder a person is shown to choose from.
//
// Output    folders and files by name, and when they were changed; why there are none, as a
// sentence Left out  hidden files, sizes.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace tact {

struct FolderEntry {
    std::string name;
    bool is_folder = false;
    std::string changed{};  // "2026-11-23 18:40", by the clock on the wall; empty: not known

    bool operator==(const FolderEntry&) const = default;
};

struct FolderListing {
    std::filesystem::path folder;
    std::vector<FolderEntry> entries;  // folders first, then in natural order: 2 before 10
    std::string fault;                 // why there are none, as a sentence
};

// Without hidden files, and of the files those with one of the extensions (".wav"; none: all).
FolderListing list_folder(const std::filesystem::path& folder,
                          const std::vector<std::string>& extensions);

// One of the extensions, case aside; without any, every name has.
bool has_extension(const std::string& name, const std::vector<std::string>& extensions);

// The root where the environment does not tell.
std::filesystem::path home_folder();

// False also for what cannot be looked at.
bool is_folder(const std::filesystem::path& path);

}  // namespace tact
