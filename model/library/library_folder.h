// A folder as a library, and what is kept of it from one time to the next.
//
// The index lies in the folder as .tactspace-library.json, one file of JSON: a library of thousands
// is a few megabytes, read in less time than a data base takes to open, and it can be looked at and
// thrown away. It holds no vibrations: they are in their files, and two places would differ.
//
// Input     any folder: effects, recordings and sets (model/io/set) in it and in its folders
// Output    entries in natural order of their files; what cannot be read is left out with its
//           reason. A file counts as unchanged while its size and its time of change are the same
// Valid     kMostLibraryFiles files
// Left out  zip files; hidden files; what lies in measured/ beside a set
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <stop_token>
#include <string>
#include <string_view>

#include "model/common/expected.h"
#include "model/library/library.h"

namespace tact {

inline constexpr std::size_t kMostLibraryFiles = 20'000;
inline constexpr const char* kLibraryFile = ".tactspace-library.json";

struct LibraryOptions {
    int threads = 0;        // 0: all cores
    bool read_all = false;  // nothing is taken from the index
    bool keep = true;       // the index is written, where anything is new
    std::stop_token stop{};
    std::function<void(double)> progress{};  // 0..1, from any thread
};

// Reads what is new or has changed. That an index could not be written or was damaged is a remark.
Expected<Library> open_library(const std::filesystem::path& folder,
                               const LibraryOptions& options = {});

// The vibration of an entry, read from its file as it is now; an Error where the file is gone or
// holds another one.
Expected<Vibration> vibration_of(const Library& library, const LibraryEntry& entry);

// The index as text, and back; an Error where it is damaged or of another version.
std::string print_library(const Library& library);
Expected<Library> parse_library(std::string_view text, const std::filesystem::path& folder);

}  // namespace tact
