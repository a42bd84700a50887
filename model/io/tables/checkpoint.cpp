#include "model/io/tables/checkpoint.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <fstream>
#include <system_error>
#include <utility>
#include <vector>

#include "model/common/fingerprint.h"
#include "model/text/atomic_file.h"

namespace tact {

namespace fs = std::filesystem;

namespace {

constexpr std::array<char, 16> kMagic{'t', 'a', 'c', 't', 's', 'p', 'a', 'c',
                                      'e', ' ', 't', 'i', 'l', 'e', 's', '\n'};
// To be raised with the format, and with any change of the numbers that equal codes give.
constexpr std::uint32_t kVersion = 2;
constexpr std::uint32_t kByteOrder = 0x01020304;
// How much a power cut may cost. Being killed costs nothing of it.
constexpr std::chrono::seconds kSyncEvery{5};

struct Header {
    std::array<char, 16> magic = kMagic;
    std::uint32_t version = kVersion;
    std::uint32_t byte_order = kByteOrder;
    TileKey key;
};
static_assert(sizeof(Header) == 64, "no gaps: it is written as it lies in memory");

struct RecordHead {
    std::uint32_t part = 0;
    std::uint32_t tile = 0;
    std::uint32_t values = 0;
    std::uint32_t checksum = 0;  // of all the rest
};
static_assert(sizeof(RecordHead) == 16, "no gaps: it is written as it lies in memory");

std::uint32_t checksum_of(RecordHead head, std::span<const double> values) {
    head.checksum = 0;
    const auto sum = mixed(mixed(0, std::span<const RecordHead>(&head, 1)), values);
    return static_cast<std::uint32_t>(sum >> 32U);
}

Error fault(const fs::path& path, const std::string& what) {
    return Error{path.string() + ": " + what};
}

Error not_written(const fs::path& path, std::error_code why) {
    return fault(path, "cannot be written: " + why.message());
}

struct Record {
    RecordHead head;
    std::vector<double> values;
};

// The whole record at a place; false if it is missing or torn.
bool read_record(const OpenFile& file, std::uint64_t place, std::uint64_t patterns,
                 Record& record) {
    RecordHead& head = record.head;
    if (file.read_at(place, &head, sizeof head) != sizeof head) return false;
    if (head.part > static_cast<std::uint32_t>(Part::oc)) return false;
    if (head.tile >= tile_count(patterns)) return false;
    if (head.values != pair_count(tile_at(patterns, head.tile))) return false;
    record.values.resize(head.values);
    const std::size_t size = head.values * sizeof(double);
    return file.read_at(place + sizeof head, record.values.data(), size) == size &&
           head.checksum == checksum_of(head, record.values);
}

std::uint64_t size_of(const Record& record) {
    return sizeof record.head + record.values.size() * sizeof(double);
}

// Where the next whole record begins, from `place` on; none up to the end of the file.
std::optional<std::uint64_t> next_record(const OpenFile& file, std::uint64_t place,
                                         std::uint64_t patterns, Record& record) {
    std::error_code none;
    const std::uint64_t end = file.facts(none).bytes;
    for (; place + sizeof(RecordHead) <= end; place += sizeof(double)) {
        if (read_record(file, place, patterns, record)) return place;
    }
    return std::nullopt;
}

std::string what_differs(const TileKey& kept, const TileKey& wanted) {
    const bool of_patterns =
        kept.patterns != wanted.patterns || kept.vibrations != wanted.vibrations;
    const bool of_model = kept.model != wanted.model;
    if (of_patterns && of_model)
        return "belongs to other patterns and other parameters of the model";
    if (of_patterns) return "belongs to other patterns";
    if (of_model) return "belongs to other parameters of the model";
    return "was begun by another build of tactspace, or on a machine with other arithmetic: the "
           "same "
           "patterns and parameters gave other numbers there";
}

}  // namespace

TileKey key_of(const TileSource& source) {
    const std::size_t patterns = pattern_count(source);
    return {patterns, tile_side(patterns), source.vibrations, source.model, fingerprint(source)};
}

std::optional<TileKey> kept_key(const fs::path& path) {
    Header header;
    std::ifstream file(path, std::ios::binary);
    if (!file.read(reinterpret_cast<char*>(&header), sizeof header)) return std::nullopt;
    const Header expected{.key = header.key};
    if (std::memcmp(&header, &expected, sizeof header) != 0) return std::nullopt;
    return header.key;
}

Expected<Checkpoint> Checkpoint::open(const fs::path& path, const TileKey& key) {
    Expected<OpenFile> file = open_alone(path, true);
    if (!file) return file.error();
    Checkpoint checkpoint(path, *std::move(file), key.patterns);
    if (const auto taken = checkpoint.take_up(key); !taken) return taken.error();
    return checkpoint;
}

Expected<Done> Checkpoint::take_up(const TileKey& key) {
    const Header expected{.key = key};
    Header header;
    const std::size_t got = file_.read_at(0, &header, sizeof header);
    const bool is_begun = got < sizeof header && std::memcmp(&header, &expected, got) == 0;
    if (!is_begun && header.magic != kMagic) {
        return fault(path_, "is no checkpoint of tactspace; expected to keep one under this name");
    }
    if (is_begun) {
        // A new file, or one of which not even the header came to be.
        const std::string_view bytes(reinterpret_cast<const char*>(&expected), sizeof expected);
        std::error_code why = file_.cut(0);
        if (!why) why = file_.write(bytes);
        if (why) return not_written(path_, why);
        end_ = sizeof expected;
        return Done{};
    }
    if (header.version != kVersion || header.byte_order != kByteOrder) {
        return fault(path_,
                     "was written by another version of tactspace or on another kind of "
                     "machine; remove it to start again");
    }
    if (header.key != key) {
        return fault(path_, what_differs(header.key, key) + "; remove it to start again");
    }
    Record record;
    end_ = sizeof header;
    while (const auto place = next_record(file_, end_, patterns_, record)) {
        if (*place != end_) ++damaged_places_;
        end_ = *place + size_of(record);
    }
    if (const std::error_code why = file_.cut(end_)) return not_written(path_, why);
    return Done{};
}

Expected<Done> Checkpoint::read(Part part, const Take& take) const {
    Record record;
    for (std::uint64_t place = sizeof(Header); place < end_;) {
        const auto found = next_record(file_, place, patterns_, record);
        if (!found || *found >= end_) {
            return fault(path_, "cannot be read again; it changed meanwhile");
        }
        place = *found + size_of(record);
        if (record.head.part == static_cast<std::uint32_t>(part)) {
            take(record.head.tile, record.values);
        }
    }
    return Done{};
}

Expected<Done> Checkpoint::append(Part part, std::size_t tile, std::span<const double> values) {
    RecordHead head{static_cast<std::uint32_t>(part), static_cast<std::uint32_t>(tile),
                    static_cast<std::uint32_t>(values.size()), 0};
    head.checksum = checksum_of(head, values);
    std::string bytes(reinterpret_cast<const char*>(&head), sizeof head);
    bytes.append(reinterpret_cast<const char*>(values.data()), values.size_bytes());
    if (const std::error_code why = file_.write(bytes)) return not_written(path_, why);
    const auto now = std::chrono::steady_clock::now();
    if (now - synced_ >= kSyncEvery) {
        file_.sync_content();
        synced_ = now;
    }
    return Done{};
}

void Checkpoint::remove() {
    std::error_code none;
    fs::remove(path_, none);
}

}  // namespace tact
