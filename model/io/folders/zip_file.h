// A zip file, of which nothing is ever unpacked to the disk.
//
// Source    APPNOTE 6.3 of PKWARE: the list at the end, zip64 too; inflating by zlib
// Output    what it holds, as a folder would; the bytes of one file at a time. Names in UTF-8 with
//           '/' between; names in no UTF-8 are those of code page 437. Errors as "FILE: .."
// Valid     kMostZipListBytes of list, kMostZipEntries files and folders; unpacked at most
//           kMostUnpackedBytes in all and, beyond kFreelyUnpackedBytes, kMostUnpackedTimes what is
//           packed: the list says so before anything is unpacked, and no file may hold more than
//           the list says of it. Stored or deflated
// Left out  passwords, archives of several parts, other ways to pack; those files are named
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "model/common/expected.h"

namespace tact {

inline constexpr std::size_t kMostZipListBytes = std::size_t{1} << 25;
inline constexpr std::size_t kMostZipEntries = 100'000;
inline constexpr std::uint64_t kMostUnpackedBytes = std::uint64_t{1} << 31;
inline constexpr std::uint64_t kFreelyUnpackedBytes = std::uint64_t{1} << 26;
inline constexpr std::uint64_t kMostUnpackedTimes = 200;

struct ZipEntry {
    std::string name;   // "clicks/a.wav"; of a folder with "/" at its end
    std::string fault;  // why it cannot be read, as the end of a sentence; or empty
    std::uint64_t at = 0;
    std::uint64_t packed_bytes = 0;
    std::uint64_t bytes = 0;
    std::uint32_t check_sum = 0;
    bool is_deflated = false;
};

struct ZipFile {
    std::filesystem::path path;
    std::vector<ZipEntry> entries;  // in the order of the list
};

// By what it begins with.
bool is_zip_file(const std::filesystem::path& path);

Expected<ZipFile> open_zip_file(const std::filesystem::path& path);

// The whole of a file; an Error where it is damaged, or larger than `most_bytes`.
Expected<std::string> unpacked(const ZipFile& zip, const ZipEntry& entry, std::size_t most_bytes);

// The first bytes of a file; empty where it cannot be read.
std::string unpacked_head(const ZipFile& zip, const ZipEntry& entry, std::size_t bytes);

}  // namespace tact
