#include "model/io/folders/zip_file.h"

#include <zlib.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <set>

#include "model/text/numbers.h"
#include "model/text/utf8.h"

namespace tact {

namespace fs = std::filesystem;

namespace {

constexpr std::uint64_t kLocalBytes = 30;
constexpr std::uint64_t kEntryBytes = 46;
constexpr std::uint64_t kEndBytes = 22;
constexpr std::uint64_t kLargeEndBytes = 56;
constexpr std::uint64_t kLocatorBytes = 20;
constexpr std::uint32_t kIsLarge = 0xFFFFFFFF;  // the number stands in 64 bits elsewhere
constexpr const char* kDamaged = "is damaged: expected a whole zip file";

// A little-endian number; 0 beyond the end.
std::uint64_t number_at(std::string_view bytes, std::size_t at, std::size_t count) {
    std::uint64_t number = 0;
    for (std::size_t k = 0; k < count && at + k < bytes.size(); ++k) {
        number |= std::uint64_t{static_cast<unsigned char>(bytes[at + k])} << 8 * k;
    }
    return number;
}

// As many of the bytes as there are.
std::string bytes_at(std::ifstream& stream, std::uint64_t at, std::size_t count) {
    std::string bytes(count, '\0');
    stream.clear();
    stream.seekg(static_cast<std::streamoff>(at));
    if (!stream) return {};
    stream.read(bytes.data(), static_cast<std::streamsize>(count));
    bytes.resize(static_cast<std::size_t>(std::max<std::streamsize>(stream.gcount(), 0)));
    return bytes;
}

// Where the list of the files is.
struct ListPlace {
    std::uint64_t entries = 0;
    std::uint64_t bytes = 0;
    std::uint64_t at = 0;
    std::uint64_t moved = 0;  // what stands before the archive, as its own places leave out
    std::string fault;
};

// `end`: where the record of the end begins.
void read_large_end(std::ifstream& stream, std::uint64_t& end, ListPlace& place) {
    if (end < kLocatorBytes) return;
    const std::string locator = bytes_at(stream, end - kLocatorBytes, kLocatorBytes);
    if (!locator.starts_with("PK\x06\x07")) return;
    std::uint64_t at = number_at(locator, 8, 8);
    std::string large = bytes_at(stream, at, kLargeEndBytes);
    // Where something stands before the archive, its own places are too small.
    if (!large.starts_with("PK\x06\x06") && end >= kLocatorBytes + kLargeEndBytes) {
        at = end - kLocatorBytes - kLargeEndBytes;
        large = bytes_at(stream, at, kLargeEndBytes);
    }
    if (large.size() < kLargeEndBytes || !large.starts_with("PK\x06\x06")) {
        place.fault = kDamaged;
        return;
    }
    place.entries = number_at(large, 32, 8);
    place.bytes = number_at(large, 40, 8);
    place.at = number_at(large, 48, 8);
    end = at;
}

ListPlace place_of_list(std::ifstream& stream, std::uint64_t size) {
    ListPlace place;
    const std::uint64_t looked_at = std::min<std::uint64_t>(size, kEndBytes + 0xFFFF);
    const std::string tail =
        bytes_at(stream, size - looked_at, static_cast<std::size_t>(looked_at));
    const std::size_t found = tail.rfind("PK\x05\x06");
    if (found == tail.npos || found + kEndBytes > tail.size()) {
        place.fault = kDamaged;
        return place;
    }
    const std::uint64_t disk = number_at(tail, found + 4, 2);
    place.entries = number_at(tail, found + 10, 2);
    place.bytes = number_at(tail, found + 12, 4);
    place.at = number_at(tail, found + 16, 4);
    std::uint64_t end = size - looked_at + found;
    if (place.entries == 0xFFFF || place.at == kIsLarge || place.bytes == kIsLarge) {
        read_large_end(stream, end, place);
    } else if (disk != 0) {
        place.fault = "is one part of several: expected a zip file of one part";
    }
    if (!place.fault.empty()) return place;
    if (place.bytes > end || place.at > end - place.bytes) {
        place.fault = kDamaged;
        return place;
    }
    place.moved = end - place.bytes - place.at;
    place.at += place.moved;
    return place;
}

// Code page 437 from 0x80 on, as zip files of old have their names.
std::string from_dos(std::string_view bytes) {
    constexpr std::u16string_view kLetters =
        u"\u00C7\u00FC\u00E9\u00E2\u00E4\u00E0\u00E5\u00E7\u00EA\u00EB\u00E8\u00EF\u00EE\u00EC"
        u"\u00C4\u00C5\u00C9\u00E6\u00C6\u00F4\u00F6\u00F2\u00FB\u00F9\u00FF\u00D6\u00DC\u00A2"
        u"\u00A3\u00A5\u20A7\u0192\u00E1\u00ED\u00F3\u00FA\u00F1\u00D1\u00AA\u00BA\u00BF\u2310"
        u"\u00AC\u00BD\u00BC\u00A1\u00AB\u00BB\u2591\u2592\u2593\u2502\u2524\u2561\u2562\u2556"
        u"\u2555\u2563\u2551\u2557\u255D\u255C\u255B\u2510\u2514\u2534\u252C\u251C\u2500\u253C"
        u"\u255E\u255F\u255A\u2554\u2569\u2566\u2560\u2550\u256C\u2567\u2568\u2564\u2565\u2559"
        u"\u2558\u2552\u2553\u256B\u256A\u2518\u250C\u2588\u2584\u258C\u2590\u2580\u03B1\u00DF"
        u"\u0393\u03C0\u03A3\u03C3\u00B5\u03C4\u03A6\u0398\u03A9\u03B4\u221E\u03C6\u03B5\u2229"
        u"\u2261\u00B1\u2265\u2264\u2320\u2321\u00F7\u2248\u00B0\u2219\u00B7\u221A\u207F\u00B2"
        u"\u25A0\u00A0";
    static_assert(kLetters.size() == 128);
    std::string text;
    for (const char one : bytes) {
        const auto byte = static_cast<unsigned char>(one);
        append_utf8(text, byte < 0x80 ? byte : kLetters[byte - 0x80U]);
    }
    return text;
}

std::string name_in(std::string_view bytes) {
    std::string name = first_invalid_utf8(bytes) ? from_dos(bytes) : std::string(bytes);
    std::ranges::replace(name, '\\', '/');
    return name;
}

// What is wrong with a name: it is empty, or leads out of the archive.
std::string fault_of_name(std::string_view name) {
    const bool has_drive = name.size() > 1 && name[1] == ':';
    bool is_bad = name.empty() || name[0] == '/' || has_drive;
    is_bad |=
        std::ranges::any_of(name, [](char c) { return static_cast<unsigned char>(c) < 0x20; });
    for (std::size_t from = 0; from < name.size();) {
        const std::size_t end = std::min(name.find('/', from), name.size());
        is_bad |= name.substr(from, end - from) == "..";
        from = end + 1;
    }
    return is_bad ? "expected a name inside of the zip file" : "";
}

// Takes what stands in 64 bits in the place of those numbers that do not fit into 32.
void take_large_numbers(std::string_view extra, ZipEntry& entry) {
    while (extra.size() >= 4) {
        const std::size_t size = std::min<std::size_t>(number_at(extra, 2, 2), extra.size() - 4);
        if (number_at(extra, 0, 2) == 1) {
            std::size_t at = 4;
            for (std::uint64_t* number : {&entry.bytes, &entry.packed_bytes, &entry.at}) {
                if (*number != kIsLarge || at + 8 > 4 + size) continue;
                *number = number_at(extra, at, 8);
                at += 8;
            }
        }
        extra.remove_prefix(4 + size);
    }
}

std::string fault_of_packing(std::string_view record) {
    const std::uint64_t method = number_at(record, 10, 2);
    if ((number_at(record, 8, 2) & 1U) != 0 || method == 99) {
        return "is encrypted: expected a zip file without a password";
    }
    if (method == 0 || method == 8) return {};
    return "is packed by method " + std::to_string(method) +
           " of zip: expected stored or deflated files";
}

bool is_link(std::string_view record) {
    const bool is_of_unix = number_at(record, 5, 1) == 3;
    return is_of_unix && (number_at(record, 40, 2) & 0xF000U) == 0xA000U;
}

// Takes the first record from the list; false if the list is empty.
bool take_entry(std::string_view& list, ZipEntry& entry) {
    if (list.size() < kEntryBytes || !list.starts_with("PK\x01\x02")) return false;
    const std::size_t name_bytes = number_at(list, 28, 2);
    const std::size_t extra_bytes = number_at(list, 30, 2);
    const std::size_t all = kEntryBytes + name_bytes + extra_bytes + number_at(list, 32, 2);
    if (all > list.size()) return false;
    entry.name = name_in(list.substr(kEntryBytes, name_bytes));
    entry.is_deflated = number_at(list, 10, 2) == 8;
    entry.check_sum = static_cast<std::uint32_t>(number_at(list, 16, 4));
    entry.packed_bytes = number_at(list, 20, 4);
    entry.bytes = number_at(list, 24, 4);
    entry.at = number_at(list, 42, 4);
    take_large_numbers(list.substr(kEntryBytes + name_bytes, extra_bytes), entry);
    entry.fault = fault_of_name(entry.name);
    if (entry.fault.empty()) entry.fault = fault_of_packing(list);
    if (entry.fault.empty() && is_link(list)) entry.fault = "a link is not followed";
    list.remove_prefix(all);
    return true;
}

// What is wrong with so much, as the end of a sentence; or empty.
std::string fault_of_size(std::uint64_t bytes, std::uint64_t packed_bytes) {
    const std::uint64_t most = std::min(
        kMostUnpackedBytes, std::max(kFreelyUnpackedBytes, kMostUnpackedTimes * packed_bytes));
    if (bytes <= most) return {};
    return "expected files of at most " + grouped_digits(static_cast<std::size_t>(most)) +
           " bytes in all, got " + grouped_digits(static_cast<std::size_t>(bytes));
}

std::string read_list(std::string_view list, const ListPlace& place, std::uint64_t file_bytes,
                      ZipFile& zip) {
    std::set<std::string, std::less<>> names;
    std::uint64_t bytes = 0;
    for (std::uint64_t k = 0; k < place.entries; ++k) {
        ZipEntry entry;
        if (!take_entry(list, entry)) return kDamaged;
        entry.at += place.moved;
        if (!names.insert(entry.name).second) entry.fault = "is there twice";
        // Numbers of 64 bits may be anything, and so may their sum.
        bytes = std::max(bytes, std::max(entry.bytes, bytes + entry.bytes));
        if (auto fault = fault_of_size(bytes, file_bytes); !fault.empty()) return fault;
        zip.entries.push_back(std::move(entry));
    }
    return {};
}

struct Inflater {
    z_stream stream{};
    bool is_ready = inflateInit2(&stream, -MAX_WBITS) == Z_OK;

    Inflater() = default;
    Inflater(const Inflater&) = delete;  // zlib keeps the stream's place
    Inflater& operator=(const Inflater&) = delete;
    ~Inflater() {
        if (is_ready) inflateEnd(&stream);
    }
};

// At most `most` bytes; fewer where the packed bytes end, or are wrong.
std::string inflated(std::ifstream& stream, std::uint64_t at, std::uint64_t packed,
                     std::size_t most) {
    Inflater inflater;
    if (!inflater.is_ready) return {};
    z_stream& raw = inflater.stream;
    constexpr std::size_t kPiece = std::size_t{1} << 16;
    std::string result;
    std::string piece;
    std::array<char, kPiece> out{};
    for (int state = Z_OK; state == Z_OK && result.size() < most;) {
        if (raw.avail_in == 0) {
            piece = bytes_at(stream, at,
                             static_cast<std::size_t>(std::min<std::uint64_t>(kPiece, packed)));
            if (piece.empty()) break;
            at += piece.size();
            packed -= piece.size();
            raw.next_in = reinterpret_cast<Bytef*>(piece.data());
            raw.avail_in = static_cast<uInt>(piece.size());
        }
        raw.next_out = reinterpret_cast<Bytef*>(out.data());
        raw.avail_out = static_cast<uInt>(std::min(kPiece, most - result.size()));
        const std::size_t room = raw.avail_out;
        state = inflate(&raw, Z_NO_FLUSH);
        if (state == Z_BUF_ERROR) state = Z_OK;
        result.append(out.data(), room - raw.avail_out);
    }
    return result;
}

// The first `most` bytes of a file.
std::string first_bytes(const ZipFile& zip, const ZipEntry& entry, std::size_t most) {
    std::ifstream stream(zip.path, std::ios::binary);
    const std::string local = bytes_at(stream, entry.at, kLocalBytes);
    if (local.size() < kLocalBytes || !local.starts_with("PK\x03\x04")) return {};
    const std::uint64_t at =
        entry.at + kLocalBytes + number_at(local, 26, 2) + number_at(local, 28, 2);
    if (entry.is_deflated) return inflated(stream, at, entry.packed_bytes, most);
    return bytes_at(stream, at, std::min<std::size_t>(most, entry.packed_bytes));
}

std::string place_in(const ZipFile& zip, const ZipEntry& entry) {
    return (zip.path / entry.name).string() + ": ";
}

}  // namespace

bool is_zip_file(const fs::path& path) {
    std::error_code none;
    if (!fs::is_regular_file(path, none)) return false;
    std::ifstream stream(path, std::ios::binary);
    const std::string head = bytes_at(stream, 0, 4);
    return head == "PK\x03\x04" || head == "PK\x05\x06";
}

Expected<ZipFile> open_zip_file(const fs::path& path) {
    const auto refused = [&path](const std::string& why) {
        return Error{path.string() + ": " + why};
    };
    std::error_code fault;
    const std::uint64_t size = fs::file_size(path, fault);
    std::ifstream stream(path, std::ios::binary);
    if (fault || !stream) return refused("cannot be read");
    const ListPlace place = place_of_list(stream, size);
    if (!place.fault.empty()) return refused(place.fault);
    if (place.entries > kMostZipEntries || place.bytes > kMostZipListBytes) {
        return refused("expected at most " + grouped_digits(kMostZipEntries) +
                       " files and folders in all");
    }
    const std::string list = bytes_at(stream, place.at, static_cast<std::size_t>(place.bytes));
    ZipFile zip{path, {}};
    if (const std::string why = read_list(list, place, size, zip); !why.empty()) {
        return refused(why);
    }
    return zip;
}

Expected<std::string> unpacked(const ZipFile& zip, const ZipEntry& entry, std::size_t most_bytes) {
    if (!entry.fault.empty()) return Error{place_in(zip, entry) + entry.fault};
    if (entry.bytes > most_bytes) {
        return Error{place_in(zip, entry) + "expected at most " + grouped_digits(most_bytes) +
                     " bytes, got " + grouped_digits(static_cast<std::size_t>(entry.bytes))};
    }
    // One byte more than is said would show that the list is wrong.
    std::string bytes = first_bytes(zip, entry, static_cast<std::size_t>(entry.bytes) + 1);
    const auto* data = reinterpret_cast<const Bytef*>(bytes.data());
    const bool is_whole =
        bytes.size() == entry.bytes && crc32_z(0, data, bytes.size()) == entry.check_sum;
    if (!is_whole) {
        return Error{place_in(zip, entry) + "is damaged: it is not what the zip file says of it"};
    }
    return bytes;
}

std::string unpacked_head(const ZipFile& zip, const ZipEntry& entry, std::size_t bytes) {
    if (!entry.fault.empty()) return {};
    return first_bytes(zip, entry,
                       static_cast<std::size_t>(std::min<std::uint64_t>(bytes, entry.bytes)));
}

}  // namespace tact
