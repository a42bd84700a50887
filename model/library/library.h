// A library: what a folder of effects, recordings and sets holds, in so few numbers that thousands
// can be listed and searched without reading their files again.
//
// Left out  the vibrations themselves, which stay in their files (library_folder.h)
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "model/set/pattern_set.h"

namespace tact {

// Strength over time: root mean squares of equal parts of a vibration's own time, as shares of the
// largest.
inline constexpr std::size_t kShapeParts = 32;
using StrengthShape = std::array<double, kShapeParts>;

struct LibraryEntry {
    std::string name;       // not unique: others may be called the same
    std::size_t file = 0;   // in Library::files
    std::size_t place = 0;  // among what its file holds
    std::string note;       // description, tags, and where it comes from
    EffectOrigin effect{};
    bool recording = false;
    bool synthetic = false;  // a measurement that was computed
    double duration_s = 0.0;
    double peak_g = 0.0;
    std::optional<double> mean_hz;  // by power; none of silence
    std::size_t ticks = 0;          // transients
    StrengthShape shape{};

    bool operator==(const LibraryEntry&) const = default;
};

// By which a changed file is known.
struct FileStamp {
    std::uint64_t bytes = 0;
    std::int64_t modified_ns = 0;

    bool operator==(const FileStamp&) const = default;
};

struct LibraryFile {
    std::string path;    // from the library's folder
    std::string beside;  // a second file that belongs to it: of an AHAP pair, of a WAV's scale
    FileStamp stamp{};
    FileStamp beside_stamp{};
    std::string licence;   // as a file that lies with it or above states it; empty: none does
    std::string left_out;  // why it could not be read, as "FILE: what was expected"; or empty

    bool operator==(const LibraryFile&) const = default;
};

struct Library {
    std::filesystem::path folder;
    std::vector<LibraryFile> files;     // those without an entry are in it, too
    std::vector<LibraryEntry> entries;  // by file, then by place
    std::vector<std::string> remarks{};
    std::size_t files_read = 0;  // the others are known from before
};

// What a list says of a vibration; file and place are the caller's.
LibraryEntry entry_of(const Vibration& vibration);

// Why files could not be read, one each.
std::vector<std::string> reasons_left_out(const Library& library);

// Its file, as the list shows it.
const LibraryFile& file_of(const Library& library, const LibraryEntry& entry);

// Finding in a library: by words, and by a shape of strength over time that somebody draws.

// Places of the entries that have every word somewhere: in their name, description, tags, file,
// format or licence. Upper and lower case are one; no word finds all.
std::vector<std::size_t> found_by_words(const Library& library, std::string_view words);

// Strengths at equal steps from the beginning to the end, straight lines between, as a shape whose
// largest is 1; none of fewer than two, of negative ones, or of nothing but zeros.
std::optional<StrengthShape> shape_through(const std::vector<double>& strengths);

// Root of the mean squared difference: 0 of the same shape, at most 1.
double shape_difference(const StrengthShape& a, const StrengthShape& b);

}  // namespace tact
