// Finished tiles in a file, so that a stopped computation can continue.
//
//     header   "tactspace tiles\n", version, byte order, patterns, side of a tile, fingerprints
//     record   part, tile, number of values, checksum; the values as 64-bit floats
//     record   ...
//
// Records are appended whole, each by one system call: when the program is killed, all but the
// running tiles are in the file. What a power cut left of the last ones does not match its checksum
// and is cut off. Damage in the middle costs the records that it is in: the next whole one is
// looked for, as every record begins at a multiple of 8 bytes.
//
// Output    errors as "PATH: what is wrong with it, what to do"
// Left out  exchange between machines of different byte order: refused.
#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <string>

#include "model/common/expected.h"
#include "model/perceptual_model/tiles.h"
#include "model/system/open_file.h"

namespace tact {

// What tiles must agree in to belong to one matrix. The codes are made from the other two: only
// where arithmetic differs, they differ alone.
struct TileKey {
    std::uint64_t patterns = 0;
    std::uint64_t side = 0;
    std::uint64_t vibrations = 0;  // fingerprints: of what was coded,
    std::uint64_t model = 0;       // of the model's parameters,
    std::uint64_t codes = 0;       // and of the codes

    bool operator==(const TileKey&) const = default;
};

TileKey key_of(const TileSource& source);

// The key that a file was begun with; none: there is no such file, or it is no checkpoint of this
// version.
std::optional<TileKey> kept_key(const std::filesystem::path& path);

// The open file. No other process can have it open meanwhile.
class Checkpoint {
  public:
    // Takes up the file or makes it. An Error if it is no checkpoint, or one of another matrix,
    // which says what is other; it is left as it was.
    static Expected<Checkpoint> open(const std::filesystem::path& path, const TileKey& key);

    // Calls `take` with every tile of one part that the file held when it was opened.
    using Take = std::function<void(std::size_t tile, std::span<const double> values)>;
    Expected<Done> read(Part part, const Take& take) const;

    // Places in the middle of the file that hold no record: damage, passed over.
    std::size_t damaged_places() const { return damaged_places_; }

    // A failed append leaves a torn record: append no more.
    Expected<Done> append(Part part, std::size_t tile, std::span<const double> values);

    // The work is done: away with the file.
    void remove();

  private:
    Checkpoint(std::filesystem::path path, OpenFile file, std::uint64_t patterns)
        : path_(std::move(path)), file_(std::move(file)), patterns_(patterns) {}
    Expected<Done> take_up(const TileKey& key);

    std::filesystem::path path_;
    OpenFile file_;
    std::uint64_t patterns_ = 0;
    std::uint64_t end_ = 0;  // of the records that were there
    std::size_t damaged_places_ = 0;
    std::chrono::steady_clock::time_point synced_ = std::chrono::steady_clock::now();
};

}  // namespace tact
