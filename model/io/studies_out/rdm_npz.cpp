#include "model/io/studies_out/rdm_npz.h"

#include <zlib.h>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <vector>

namespace tact {

namespace {

// Low bytes first, as zip and '<' of NumPy have them.
template <class Whole>
void append(std::string& bytes, Whole value) {
    for (std::size_t k = 0; k < sizeof(Whole); ++k) {
        bytes.push_back(static_cast<char>((value >> (8 * k)) & 0xffU));
    }
}

// The header is padded so that the data begin at a multiple of 64 bytes.
std::string npy(const std::string& type, const std::string& shape, const std::string& data) {
    std::string header =
        "{'descr': '" + type + "', 'fortran_order': False, 'shape': (" + shape + "), }";
    constexpr std::size_t kBefore = 10;  // magic, version, length
    while ((kBefore + header.size() + 1) % 64 != 0) header.push_back(' ');
    header.push_back('\n');
    std::string bytes = "\x93NUMPY";
    bytes.push_back('\x01');
    bytes.push_back('\0');
    append(bytes, static_cast<std::uint16_t>(header.size()));
    return bytes + header + data;
}

// The text is UTF-8, as names in a study are.
std::u32string letters_of(const std::string& text) {
    std::u32string letters;
    for (const char one : text) {
        const auto byte = static_cast<unsigned char>(one);
        if (byte < 0x80) {
            letters.push_back(byte);
        } else if (byte >= 0xc0) {
            letters.push_back(byte & (byte >= 0xf0 ? 0x07U : byte >= 0xe0 ? 0x0fU : 0x1fU));
        } else if (!letters.empty()) {
            letters.back() = (letters.back() << 6U) | (byte & 0x3fU);
        }
    }
    return letters;
}

std::string npy_of_texts(const std::vector<std::string>& texts) {
    std::vector<std::u32string> wide;
    std::size_t longest = 1;
    for (const std::string& text : texts) {
        wide.push_back(letters_of(text));
        longest = std::max(longest, wide.back().size());
    }
    std::string data;
    for (std::u32string& letters : wide) {
        letters.resize(longest, U'\0');
        for (const char32_t letter : letters) append(data, static_cast<std::uint32_t>(letter));
    }
    return npy("<U" + std::to_string(longest), std::to_string(texts.size()) + ",", data);
}

struct Member {
    std::string name;
    std::string bytes;
};

std::string zip_of(const std::vector<Member>& members) {
    std::string bytes;
    std::string list;
    for (const Member& member : members) {
        const auto at = static_cast<std::uint32_t>(bytes.size());
        const auto size = static_cast<std::uint32_t>(member.bytes.size());
        const auto sum = static_cast<std::uint32_t>(
            crc32(0, reinterpret_cast<const Bytef*>(member.bytes.data()), size));
        // What the entry and its line in the list share: version 2.0, no flags, stored, 1 January
        // 1980.
        std::string shared;
        append(shared, std::uint16_t{20});
        append(shared, std::uint16_t{0});
        append(shared, std::uint16_t{0});
        append(shared, std::uint16_t{0});
        append(shared, std::uint16_t{0x21});
        append(shared, sum);
        append(shared, size);
        append(shared, size);
        append(shared, static_cast<std::uint16_t>(member.name.size()));
        append(shared, std::uint16_t{0});
        append(bytes, std::uint32_t{0x04034b50});
        bytes += shared + member.name + member.bytes;
        append(list, std::uint32_t{0x02014b50});
        append(list, std::uint16_t{20});
        list += shared;
        append(list, std::uint16_t{0});
        append(list, std::uint16_t{0});
        append(list, std::uint16_t{0});
        append(list, std::uint32_t{0});
        append(list, at);
        list += member.name;
    }
    const auto count = static_cast<std::uint16_t>(members.size());
    const auto list_at = static_cast<std::uint32_t>(bytes.size());
    bytes += list;
    append(bytes, std::uint32_t{0x06054b50});
    append(bytes, std::uint16_t{0});
    append(bytes, std::uint16_t{0});
    append(bytes, count);
    append(bytes, count);
    append(bytes, static_cast<std::uint32_t>(list.size()));
    append(bytes, list_at);
    append(bytes, std::uint16_t{0});
    return bytes;
}

}  // namespace

std::string rdm_npz(const RatingStudy& study) {
    std::vector<std::string> participants;
    std::string values;
    const std::size_t pairs = pair_count(study.labels.size());
    for (const Judgement& one : participant_means(study)) {
        participants.push_back(one.participant);
        for (const double value : one.condensed)
            append(values, std::bit_cast<std::uint64_t>(value));
    }
    std::string synthetic;
    append(synthetic, std::uint64_t{is_partly_synthetic(study) ? 1U : 0U});
    return zip_of(
        {{"dissimilarities.npy",
          npy("<f8", std::to_string(participants.size()) + ", " + std::to_string(pairs), values)},
         {"participants.npy", npy_of_texts(participants)},
         {"patterns.npy", npy_of_texts(study.labels)},
         {"synthetic.npy", npy("<i8", "", synthetic)}});
}

}  // namespace tact
