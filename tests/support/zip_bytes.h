// Zip files made by hand, byte by byte: no library between the test and the format but zlib's.
#pragma once

#include <zlib.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "tests/support/wave_bytes.h"

struct ZipMember {
    std::string name;
    std::string bytes;
    bool is_deflated = true;
    bool is_encrypted = false;
    bool is_link = false;
    int method = -1;                                // else by is_deflated
    std::optional<std::uint64_t> said_bytes{};      // else as it is
    std::optional<std::uint32_t> said_check_sum{};  // else as it is
};

inline std::string deflated(const std::string& bytes) {
    z_stream stream{};
    deflateInit2(&stream, Z_BEST_COMPRESSION, Z_DEFLATED, -MAX_WBITS, 8, Z_DEFAULT_STRATEGY);
    std::string packed(deflateBound(&stream, static_cast<uLong>(bytes.size())), '\0');
    std::string in = bytes;
    stream.next_in = reinterpret_cast<Bytef*>(in.data());
    stream.avail_in = static_cast<uInt>(in.size());
    stream.next_out = reinterpret_cast<Bytef*>(packed.data());
    stream.avail_out = static_cast<uInt>(packed.size());
    deflate(&stream, Z_FINISH);
    packed.resize(stream.total_out);
    deflateEnd(&stream);
    return packed;
}

// `large`: with the records of zip64. `before`: what stands in front, as of a program that unpacks
// itself.
inline std::string zip_of(const std::vector<ZipMember>& members, bool large = false,
                          const std::string& before = "") {
    std::string bytes;
    std::string list;
    for (const ZipMember& one : members) {
        const std::string data = one.is_deflated ? deflated(one.bytes) : one.bytes;
        const auto* plain = reinterpret_cast<const Bytef*>(one.bytes.data());
        const auto sum = one.said_check_sum.value_or(
            static_cast<std::uint32_t>(crc32_z(0, plain, one.bytes.size())));
        const std::uint64_t said = one.said_bytes.value_or(one.bytes.size());
        const int method = one.method >= 0 ? one.method : one.is_deflated ? 8 : 0;
        std::string shared;
        put_number(shared, one.is_encrypted ? 1 : 0, 2);
        put_number(shared, static_cast<std::uint64_t>(method), 2);
        put_number(shared, 0, 4);
        put_number(shared, sum, 4);
        put_number(shared, large ? 0xFFFFFFFF : data.size(), 4);
        put_number(shared, large ? 0xFFFFFFFF : said, 4);
        put_number(shared, one.name.size(), 2);
        std::string extra;
        if (large) {
            put_number(extra, 1, 2);
            put_number(extra, 24, 2);
            put_number(extra, said, 8);
            put_number(extra, data.size(), 8);
            put_number(extra, bytes.size(), 8);
        }
        put_number(shared, extra.size(), 2);
        list += "PK\x01\x02";
        put_number(list, one.is_link ? 0x0314 : 0x0014, 2);
        put_number(list, 20, 2);
        list += shared;
        put_number(list, 0, 2);  // no comment
        put_number(list, 0, 4);
        put_number(list, one.is_link ? 0xA1FF0000U : 0, 4);
        put_number(list, large ? 0xFFFFFFFF : bytes.size(), 4);
        list += one.name + extra;
        bytes += "PK\x03\x04";
        put_number(bytes, 20, 2);
        bytes += shared + one.name + extra + data;
    }
    const std::size_t at = bytes.size();
    bytes += list;
    if (large) {
        const std::size_t end = bytes.size();
        bytes += "PK\x06\x06";
        put_number(bytes, 44, 8);
        put_number(bytes, 45, 2);
        put_number(bytes, 45, 2);
        put_number(bytes, 0, 8);
        put_number(bytes, members.size(), 8);
        put_number(bytes, members.size(), 8);
        put_number(bytes, list.size(), 8);
        put_number(bytes, at, 8);
        bytes += "PK\x06\x07";
        put_number(bytes, 0, 4);
        put_number(bytes, end, 8);
        put_number(bytes, 1, 4);
    }
    bytes += "PK\x05\x06";
    put_number(bytes, 0, 4);
    put_number(bytes, large ? 0xFFFF : members.size(), 2);
    put_number(bytes, large ? 0xFFFF : members.size(), 2);
    put_number(bytes, large ? 0xFFFFFFFF : list.size(), 4);
    put_number(bytes, large ? 0xFFFFFFFF : at, 4);
    put_number(bytes, 0, 2);
    return before + bytes;
}
