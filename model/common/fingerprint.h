// One number for many bytes, to notice that they are others than before.
//
// Exact     same bytes, same number, on machines of one byte order.
// Left out  protection against someone who looks for two inputs of one number.
#pragma once

#include <algorithm>
#include <cinttypes>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <span>
#include <string>
#include <string_view>

namespace tact {

// The number of what came before, with eight more bytes in it.
constexpr std::uint64_t mixed(std::uint64_t so_far, std::uint64_t word) {
    // The sum makes zeros count, too. An odd factor loses nothing; the shift brings high bits down
    // to where the next word meets them.
    constexpr std::uint64_t kOdd = 0x9e3779b97f4a7c15U;
    so_far = ((so_far ^ word) + kOdd) * kOdd;
    return so_far ^ (so_far >> 32U);
}

// Values by their bytes, and their count, so that where one array ends and the next begins counts.
template <class Value>
std::uint64_t mixed(std::uint64_t so_far, std::span<const Value> values) {
    const auto bytes = std::as_bytes(values);
    for (std::size_t k = 0; k < bytes.size(); k += sizeof(std::uint64_t)) {
        std::uint64_t word = 0;
        std::memcpy(&word, bytes.data() + k, std::min(sizeof word, bytes.size() - k));
        so_far = mixed(so_far, word);
    }
    return mixed(so_far, std::uint64_t{bytes.size()});
}

// The form written into files: 16 hexadecimal digits.
inline std::string fingerprint_text(std::uint64_t number) {
    char digits[24];
    std::snprintf(digits, sizeof digits, "%016" PRIx64, number);
    return digits;
}

inline std::uint64_t fingerprint(std::string_view bytes) {
    return mixed(0, std::span<const char>(bytes.data(), bytes.size()));
}

inline std::string fingerprint_text(std::string_view text) {
    return fingerprint_text(fingerprint(text));
}

}  // namespace tact
