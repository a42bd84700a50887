#include "model/io/recordings/wave_size.h"

#include <array>
#include <string_view>

#include "model/text/numbers.h"

namespace tact {

namespace {

constexpr std::uint64_t kOpenSize = 0xFFFFFFFF;     // of a stream, or: see the ds64 chunk
constexpr std::uint64_t kSoxOpenSize = 0x7FFFF000;  // as sox writes into a pipe

template <std::size_t kBytes>
std::uint64_t number(const std::array<char, kBytes>& bytes, std::size_t offset, std::size_t length,
                     bool big_endian) {
    std::uint64_t value = 0;
    for (std::size_t k = 0; k < length; ++k) {
        const std::size_t place = big_endian ? offset + k : offset + length - 1 - k;
        value = value << 8 | static_cast<unsigned char>(bytes[place]);
    }
    return value;
}

}  // namespace

std::string wave_size_fault(std::istream& stream, std::uint64_t file_bytes) {
    constexpr std::string_view kCut = "ends before its samples begin, expected a whole WAV file";
    std::array<char, 12> head{};
    stream.read(head.data(), head.size());
    const std::string_view form(head.data(), 4);
    if (!stream || (form != "RIFF" && form != "RIFX" && form != "RF64" && form != "BW64") ||
        std::string_view(head.data() + 8, 4) != "WAVE") {
        return "expected a WAV file (RIFF, RIFX, RF64 or BW64)";
    }
    const bool big_endian = form == "RIFX";
    const bool is_open = number(head, 4, 4, big_endian) == 0;  // a stream's writer never came back
    std::uint64_t data_bytes_64 = kOpenSize;
    for (std::uint64_t position = head.size();;) {
        std::array<char, 8> chunk{};
        stream.seekg(static_cast<std::streamoff>(position));
        if (!stream.read(chunk.data(), chunk.size())) return std::string(kCut);
        const std::string_view name(chunk.data(), 4);
        std::uint64_t bytes = number(chunk, 4, 4, big_endian);
        position += chunk.size();
        if (name == "ds64") {
            std::array<char, 16> sizes{};  // of the file and of the data
            if (!stream.read(sizes.data(), sizes.size())) return std::string(kCut);
            data_bytes_64 = number(sizes, 8, 8, false);
        }
        if (name == "data") {
            if ((form == "RF64" || form == "BW64") && bytes == kOpenSize) bytes = data_bytes_64;
            // libsndfile takes whatever follows for samples here.
            if (bytes == 0 && is_open && file_bytes > position) return {};
            if (bytes == 0) return "expected at least one sample, got none";
            if (bytes == kSoxOpenSize && file_bytes - position < bytes) return {};
            if (bytes == kOpenSize || bytes <= file_bytes - position) return {};
            return "is truncated: expected " + grouped_digits(bytes) +
                   " bytes of samples, as its header says, got " +
                   grouped_digits(file_bytes - position);
        }
        if (bytes > file_bytes - position) return std::string(kCut);
        position += bytes + bytes % 2;  // chunks start at even offsets
    }
}

}  // namespace tact
